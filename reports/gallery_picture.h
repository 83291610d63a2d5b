// SPDX-License-Identifier: MIT
//
// One picture of a gallery page, as SVG.
#pragma once

#include <pugixml.hpp>
#include <string>

#include "reports/gallery.h"

namespace edgecase {

// Appends the picture of one of the entry's images: with the outlines of primitives if pixels are
// large, lines around pixels whose colour differs, and a ring in pixels that are drawn another
// number of times. `words`: the alternative text.
void add_gallery_picture(pugi::xml_node parent, const GalleryEntry& entry,
                         const GalleryImage& image, const GalleryDifference& difference,
                         const std::string& words);

}  // namespace edgecase
