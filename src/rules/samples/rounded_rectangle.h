// SPDX-License-Identifier: MIT
//
// The rectangle of a multisampled line, rounded to a sub-pixel grid.
//
// Its corners are irrational, a +- n and b +- n with n = (width / 2) (-dy, dx) / |b - a|, and
// implementations fill polygons whose corners lie on a grid. So they round either the corners or
// the ends and n separately. The covered area is then the polygon of the rounded corners.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "exact/fixed.h"
#include "rules/coverage/segment.h"
#include "rules/coverage/tie_rule.h"

namespace edgecase {

enum class RectangleRounding {
  offset,   // ends and n to 1/256 pixel, a tie away from 0
  corners,  // corners to 1/16 pixel, a tie to the even grid line
};

// The nearest multiple for a number halfway between two.
enum class HalfwayTo { even, away_from_zero };

// The multiple of 2^-bits nearest to whole + above / sqrt(below), all in units of 2^-16.
// Magnitudes: whole up to 2^30, above up to 2^53, sqrt(below) up to 2^32, their quotient up to
// 2^22.
Fixed nearest_with_root(std::int64_t whole, std::int64_t above, std::uint64_t below, int bits,
                        HalfwayTo halfway);

// The rounded corners, counter-clockwise. The segment must have a length; width: more than 0, at
// most 64 pixels.
std::array<Point, 4> rounded_corners(const Segment& segment, Fixed width,
                                     RectangleRounding rounding);

// True if the polygon contains the sample: it lies to the left of all sides. A polygon turned over
// by rounding contains nothing.
bool rounded_rectangle_covers(const std::array<Point, 4>& corners, Point sample,
                              const TieRule& ties);

// True if the left border of some column within `bounds` runs through the polygon's extent in x,
// and the lower border of some row through its extent in y. A border on the lesser side of the
// extent counts, one on the greater side does not. llvmpipe draws no other lines: its box of pixels
// begins with the first column whose left border lies inside, and is empty if there is none.
bool crosses_borders(const std::array<Point, 4>& corners, const PixelBounds& bounds);

// The pixels within `bounds` whose sample, at position `within`, lies in the polygon of a line;
// each once, in no particular order.
std::vector<PixelPosition> rounded_rectangle_pixels(const Segment& segment, Fixed width,
                                                    RectangleRounding rounding,
                                                    const PixelBounds& bounds, Point within,
                                                    const TieRule& ties);

}  // namespace edgecase
