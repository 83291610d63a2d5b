// SPDX-License-Identifier: MIT
//
// The exact rasterizer's coverage stage where a vertex lies outside the clip volume.
#pragma once

#include <vector>

#include "exact/pixel.h"
#include "model/scene.h"
#include "rules/choices.h"

namespace edgecase {

// What is rasterized of a triangle, and through which viewport: as they are, or turned upside down.
struct ClippedTriangle {
  UnclippedTriangle triangle;
  Viewport viewport;
};

// The pixels within `bounds` whose sample, at `within` of the pixel, is covered, each once, in no
// particular order. Where the choice makes no vertices, none are snapped.
std::vector<PixelPosition> clipped_pixels(const ClippedTriangle& clipped, const PixelBounds& bounds,
                                          Point within, const CoverageChoice& choice);

}  // namespace edgecase
