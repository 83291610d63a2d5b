// SPDX-License-Identifier: MIT
//
// The report's page, and a gallery's, without what is put in, as embed_viewer.py makes them from
// reports/viewer.
#pragma once

#include <string_view>

namespace edgecase {

// The data, JSON without '<', goes between the two.
extern const std::string_view kPageBeforeData;
extern const std::string_view kPageAfterData;

// Texts as the content of elements go between these: the title, then the body.
extern const std::string_view kGalleryBeforeTitle;
extern const std::string_view kGalleryBeforeBody;
extern const std::string_view kGalleryAfterBody;

}  // namespace edgecase
