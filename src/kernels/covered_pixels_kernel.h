// SPDX-License-Identifier: MIT
//
// Lists the pixels that the kernels' walks find in a primitive.
#pragma once

#include <span>
#include <vector>

#include "exact/pixel.h"
#include "rules/coverage/segment.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {

// The pixels of triangle_covers within the bounds, which lie within the window, sorted by row, then
// column. Vertices must satisfy is_raw_point.
std::vector<PixelPosition> walked_triangle_pixels(const Triangle& triangle,
                                                  const PixelBounds& bounds, const TieRule& ties);

// Whether walked_triangle_pixels would give exactly these distinct pixels, in the same order.
bool walks_just(std::span<const PixelPosition> pixels, const Triangle& triangle,
                const PixelBounds& bounds, const TieRule& ties);

// The pixels whose samples lie on the triangle's edges, in the same order.
std::vector<PixelPosition> walked_tied_pixels(const Triangle& triangle, const PixelBounds& bounds);

// The pixels of diamond_exit_covers, ascending along the segment's major axis. The tie rule must be
// a perturbed one.
std::vector<PixelPosition> walked_line_pixels(const Segment& segment, const PixelBounds& bounds,
                                              const TieRule& ties);

}  // namespace edgecase
