// SPDX-License-Identifier: MIT
//
// One picture of a gallery page, as SVG.
#pragma once

#include <pugixml.hpp>
#include <string>

#include "reports/gallery.h"

namespace edgecase {

// Appends the picture of an image of the entry, with the outlines of primitives where pixels are
// large, lines round the pixels whose colour differs, and a ring in those that are drawn another
// number of times. `words` tell it to those who do not see it.
void add_gallery_picture(pugi::xml_node parent, const GalleryEntry& entry,
                         const GalleryImage& image, const GalleryDifference& difference,
                         const std::string& words);

}  // namespace edgecase
