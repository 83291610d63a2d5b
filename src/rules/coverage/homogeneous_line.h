// SPDX-License-Identifier: MIT
//
// Lines whose ends are quotients: the diamond-exit rule of diamond_exit.h, decided without
// dividing.
//
// Three changes make it homogeneous. A side separates a convex set from a segment exactly if both
// ends lie outside that side, so each end's coordinates are compared with the side and not with
// each other. The segment's own line is a determinant of three points. And an edge of the diamond
// is crossed between its corners if these lie on different sides of that line. Corners and sides of
// diamonds are whole halves in rotated coordinates u = x + y, v = x - y, in which a point keeps its
// w.
#pragma once

#include <vector>

#include "exact/fixed.h"
#include "exact/homogeneous.h"
#include "rules/coverage/line_algorithm.h"

namespace edgecase {

// Ends with a w of at most 2^33, as after the move of a wide line.
struct HomogeneousSegment {
  HomogeneousPoint a;
  HomogeneousPoint b;

  // As in segment.h.
  bool x_major() const;
};

// The nearest segment whose coordinates are multiples of 2^-16.
Segment nearest_segment(const HomogeneousSegment& segment);

// As in diamond_exit.h.
bool meets_diamond(const HomogeneousSegment& segment, int x, int y,
                   const DiamondBoundary& boundary);
bool ends_in_diamond(const HomogeneousSegment& segment, int x, int y,
                     const DiamondBoundary& boundary);
bool diamond_exit_covers(const HomogeneousSegment& segment, int x, int y,
                         const DiamondBoundary& boundary);
std::vector<PixelPosition> diamond_exit_pixels(const HomogeneousSegment& segment,
                                               const PixelBounds& bounds,
                                               const DiamondBoundary& boundary);

// As in line_algorithm.h. The diamond-exit rule, and wide lines made from its columns, use the
// quotients; other algorithms use the nearest segment.
HomogeneousSegment lowest_segment(const HomogeneousSegment& segment, int width);
std::vector<PixelPosition> line_pixels(const HomogeneousSegment& segment, Fixed width,
                                       const PixelBounds& bounds, const LineChoice& choice,
                                       const TieRule& ties);

}  // namespace edgecase
