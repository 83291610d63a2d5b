// SPDX-License-Identifier: MIT
//
// Lines as walks along the major axis: one pixel per column (per row, if y-major).
//
// All walks follow the line along its major axis. In each column they draw the pixel that contains
// the line at the column's centre; integer algorithms draw the pixel nearest to a line between
// integer ends. They differ in the columns that take part, and in the ends. None of them is the
// diamond-exit rule; all of them are in use.
#pragma once

#include <vector>

#include "exact/pixel.h"
#include "rules/coverage/segment.h"
#include "rules/coverage/tie_rule.h"

namespace edgecase {

// The columns that take part.
enum class WalkRange {
  floor_to_floor,       // from the start's column to the end's, both included
  ends_tested,          // the same, but the first and last pixel must pass the diamond-exit test
  half_open_direction,  // centres from the start, included, to the end, excluded
  half_open_geometry,   // centres from the left (lower) end, included, to the other, excluded
};

// The pixels within `bounds`, ascending along the major axis. A segment without length draws one
// pixel or none, depending on its range. `boundary` is only for ends_tested.
std::vector<PixelPosition> walk_pixels(const Segment& segment, const PixelBounds& bounds,
                                       WalkRange range, const DiamondBoundary& boundary);

// How integer algorithms round coordinates to pixels.
enum class ToInteger { floor, toward_zero };

// Bresenham's algorithm between the ends' pixels, from the start, without the end's pixel; if the
// line passes midway between two pixels, the step is taken. Equal distances count as y-major.
std::vector<PixelPosition> bresenham_pixels(const Segment& segment, const PixelBounds& bounds,
                                            ToInteger rounding);

// The midpoint algorithm between the ends' pixels, from left to right (bottom to top, if y-major),
// with both ends drawn; if the line passes midway between two pixels, no step is taken.
std::vector<PixelPosition> midpoint_pixels(const Segment& segment, const PixelBounds& bounds);

}  // namespace edgecase
