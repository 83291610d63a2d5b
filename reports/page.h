// SPDX-License-Identifier: MIT
//
// Templates of the report's page, a gallery's and the rule book's, made from reports/viewer by
// embed_viewer.py, and of pages that draw, from reference/web.
#pragma once

#include <string_view>

namespace edgecase {

// Between these parts are inserted: further permissions of the policy, the index as JSON without
// '<', and the elements with the blocks.
extern const std::string_view kPageBeforeLoads;
extern const std::string_view kPageBeforeData;
extern const std::string_view kPageBeforeBlocks;
extern const std::string_view kPageAfterBlocks;

// Between these parts the title and the body are inserted, as the content of elements.
extern const std::string_view kGalleryBeforeTitle;
extern const std::string_view kGalleryBeforeBody;
extern const std::string_view kGalleryAfterBody;

// The same for the rule book's pages.
extern const std::string_view kBookBeforeTitle;
extern const std::string_view kBookBeforeBody;
extern const std::string_view kBookAfterBody;

// The page that draws, with the same places as the report's; its data are JSON without '<', and it
// has no blocks.
extern const std::string_view kWebBeforeLoads;
extern const std::string_view kWebBeforeData;
extern const std::string_view kWebBeforeBlocks;
extern const std::string_view kWebAfterBlocks;

}  // namespace edgecase
