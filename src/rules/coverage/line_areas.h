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

// A superset of the pixels whose centres lie within the width of the line along its minor axis, and
// along its major axis at most half the width and `beyond` pixels outside its ends.
std::vector<PixelPosition> pixels_centred_near_line(const Segment& segment, Fixed width, int beyond,
                                                    const PixelBounds& bounds);

// The pixels within `bounds` whose centres lie in the area, along the major axis.
std::vector<PixelPosition> line_area_pixels(const Segment& segment, Fixed width, LineArea area,
                                            const PixelBounds& bounds, const TieRule& ties);

}  // namespace edgecase
