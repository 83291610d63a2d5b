// SPDX-License-Identifier: MIT
//
// The report's page, a gallery's and the rule book's, without what is put in, as embed_viewer.py
// makes them from reports/viewer.
#pragma once

#include <string_view>

namespace edgecase {

// Between these go what the policy allows beyond the page's own, the index as JSON without '<', and
// the elements that hold the blocks.
extern const std::string_view kPageBeforeLoads;
extern const std::string_view kPageBeforeData;
extern const std::string_view kPageBeforeBlocks;
extern const std::string_view kPageAfterBlocks;

// Texts as the content of elements go between these: the title, then the body.
extern const std::string_view kGalleryBeforeTitle;
extern const std::string_view kGalleryBeforeBody;
extern const std::string_view kGalleryAfterBody;

// The same of the rule book's pages.
extern const std::string_view kBookBeforeTitle;
extern const std::string_view kBookBeforeBody;
extern const std::string_view kBookAfterBody;

}  // namespace edgecase
