// SPDX-License-Identifier: MIT
//
// Lines as areas: the pixels whose centres lie in a rectangle or parallelogram round the segment.
//
// Vulkan's strict lines, and OpenGL's under multisampling, are rectangles as long as the segment
// and as wide as the line; Vulkan's other lines are parallelograms whose ends run along the minor
// axis. The rectangle's corners are irrational, its sides are not: a sample lies within half the
// width of the line when the square of a cross product is at most a quarter of w^2 times a squared
// length, which 128-bit integers hold.
#pragma once

#include <vector>

#include "exact/pixel.h"
#include "rules/coverage/segment.h"
#include "rules/coverage/tie_rule.h"

namespace edgecase {

enum class LineArea { rectangle, parallelogram };

// Does the area of a line of some width (pixels, at most 64) hold the sample, or the centre of a
// pixel? A segment without length has no area.
bool line_area_covers(const Segment& segment, Fixed width, LineArea area, Point sample,
                      const TieRule& ties);
inline bool line_area_covers(const Segment& segment, Fixed width, LineArea area,
                             PixelPosition pixel, const TieRule& ties) {
  return line_area_covers(segment, width, area, pixel_centre(pixel.x, pixel.y), ties);
}

// Pixels within `bounds`, along the major axis: every one with a point at most half the width and
// half a pixel away from the segment, and some more.
std::vector<PixelPosition> pixels_near_line(const Segment& segment, Fixed width,
                                            const PixelBounds& bounds);

// The pixels within `bounds` whose centres the area holds, along the major axis.
std::vector<PixelPosition> line_area_pixels(const Segment& segment, Fixed width, LineArea area,
                                            const PixelBounds& bounds, const TieRule& ties);

// ------------------------------------------------------------ parallelograms whose ends are tested
//
// Lines as parallelograms whose ends are tested: what Mesa's llvmpipe draws, its own approximation
// of the diamond-exit rule.
//
// The parallelogram has the segment in its middle, its ends run along the minor axis, and it is as
// high as the line is wide, rounded to an integer. Alone it would draw the pixels whose centres the
// segment passes along its major axis. So each end is asked, in single precision, whether the
// diamond-exit rule has its pixel drawn and whether the parallelogram has; where the two answers
// differ, the end is moved along the line to the border of its pixel. Then the ends are snapped,
// from the centre of pixel 0, to a grid of 1/256 pixel, ties away from zero, and what is inside is
// decided exactly: nothing where the ends have moved past each other.
//
// The tests are right but for some ties, for which of the diamond's sides a line crosses, and for
// wide lines, whose ends are tested where the segment lies and not where its lowest fragments do.
// Equal lengths count as x-major.

// The pixels within `bounds`, along the major axis; none of a segment without length. `width`:
// pixels, at least 1, already rounded. `ties` decides centres on the parallelogram's sides.
std::vector<PixelPosition> tested_ends_pixels(const Segment& segment, int width,
                                              const PixelBounds& bounds, const TieRule& ties);

}  // namespace edgecase
