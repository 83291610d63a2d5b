// SPDX-License-Identifier: MIT
//
// Lines as areas: the pixels whose centres lie in a rectangle or parallelogram round the segment.
//
// Vulkan's strict lines, and OpenGL's under multisampling, are rectangles as long as the segment
// and as wide as the line; Vulkan's other lines are parallelograms whose ends run along the minor
// axis. The rectangle's corners are irrational but its sides are not: a sample is within half the
// width of the line if the square of a cross product is at most a quarter of w^2 times a squared
// length, which fits in 128-bit integers.
#pragma once

#include <vector>

#include "exact/fixed.h"
#include "rules/coverage/segment.h"
#include "rules/coverage/tie_rule.h"

namespace edgecase {

enum class LineArea { rectangle, parallelogram };

// True if the area of a line of some width (pixels, at most 64) contains the sample, or the centre
// of a pixel. A segment without length has no area.
bool line_area_covers(const Segment& segment, Fixed width, LineArea area, Point sample,
                      const TieRule& ties);
inline bool line_area_covers(const Segment& segment, Fixed width, LineArea area,
                             PixelPosition pixel, const TieRule& ties) {
  return line_area_covers(segment, width, area, pixel_centre(pixel.x, pixel.y), ties);
}

// A superset of the pixels within `bounds` with a point at most half the width and half a pixel
// away from the segment, along the major axis.
std::vector<PixelPosition> pixels_near_line(const Segment& segment, Fixed width,
                                            const PixelBounds& bounds);

// The pixels within `bounds` whose centres lie in the area, along the major axis.
std::vector<PixelPosition> line_area_pixels(const Segment& segment, Fixed width, LineArea area,
                                            const PixelBounds& bounds, const TieRule& ties);

// ------------------------------------------------------------ parallelograms whose ends are tested
//
// Parallelograms whose ends are tested: the lines of Mesa's llvmpipe, its own approximation of the
// diamond-exit rule.
//
// The segment lies in the middle of the parallelogram, whose ends run along the minor axis and
// whose height is the line's width, rounded to an integer. By itself it would draw the pixels whose
// centres the segment passes along its major axis. So each end is tested, in single precision: does
// the diamond-exit rule draw its pixel, and does the parallelogram? If the two answers differ, the
// end is moved along the line to the border of its pixel. Then the ends are snapped, from the
// centre of pixel 0, to a grid of 1/256 pixel, ties away from zero, and the inside is decided
// exactly: nothing is inside if the ends have moved past each other.
//
// The tests are right except for some ties, for which side of the diamond a line crosses, and for
// wide lines, whose ends are tested at the segment and not at its lowest fragments. Equal lengths
// count as x-major.

// The pixels within `bounds`, along the major axis; none for a segment without length. `width`:
// pixels, at least 1, already rounded. `ties` decides centres on the parallelogram's sides.
std::vector<PixelPosition> tested_ends_pixels(const Segment& segment, int width,
                                              const PixelBounds& bounds, const TieRule& ties);

}  // namespace edgecase
