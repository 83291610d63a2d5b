// SPDX-License-Identifier: MIT
//
// The pixels of a primitive, listed, by the kernels' walks.
#pragma once

#include <span>
#include <vector>

#include "exact/pixel.h"
#include "rules/coverage/segment.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {

// The pixels of triangle_covers within the bounds, which lie within the window, sorted by row,
// column. Vertices: is_raw_point.
std::vector<PixelPosition> walked_triangle_pixels(const Triangle& triangle,
                                                  const PixelBounds& bounds, const TieRule& ties);

// Are they just these pixels, which are sorted likewise, none twice?
bool walks_just(std::span<const PixelPosition> pixels, const Triangle& triangle,
                const PixelBounds& bounds, const TieRule& ties);

// The pixels whose samples lie in the triangle, but not off its edges, likewise.
std::vector<PixelPosition> walked_tied_pixels(const Triangle& triangle, const PixelBounds& bounds);

// Those of diamond_exit_covers, along the segment's major axis in ascending order. The tie rule is
// a perturbed one.
std::vector<PixelPosition> walked_line_pixels(const Segment& segment, const PixelBounds& bounds,
                                              const TieRule& ties);

}  // namespace edgecase
