// SPDX-License-Identifier: MIT
//
// Lines of width 1: the diamond-exit rule (GL 4.6 core, 14.5.1).
//
// An open diamond, |dx| + |dy| < 1/2, surrounds each pixel's centre. A segment from a to b produces
// a fragment for each diamond that it exits. These are all diamonds that it meets, except the one
// that contains b. The rule first moves both ends by -(e, e^2), so that no result depends on a
// diamond's boundary. We move the diamond by +(e, e^2) instead, which is tie rule `left-bottom`.
//
// In the rotated coordinates u = x + y, v = x - y the diamond is an open square with sides parallel
// to the axes. A segment meets an open convex set unless a direction separates the two. Three
// directions can do so here: u, v, and the segment's normal. They give six linear functions of the
// sample, which must all be positive. Four more functions say whether b lies inside. The test needs
// no square root, no division and no rounding.
#pragma once

#include <vector>

#include "exact/fixed.h"
#include "rules/coverage/segment.h"
#include "rules/coverage/tie_rule.h"
#include "rules/rule.h"

namespace edgecase {

Rule diamond_exit_rule();
Rule interior_gap_rule();
inline constexpr int kRulingOnUnseenLine = 2;  // without a fragment
inline constexpr int kRulingOnEmptyLine = 58;  // its single fragment

// True if the segment meets the diamond of pixel (x, y).
bool meets_diamond(const Segment& segment, int x, int y, const DiamondBoundary& boundary);

// True if the diamond of pixel (x, y) contains the end of the segment.
bool ends_in_diamond(const Segment& segment, int x, int y, const DiamondBoundary& boundary);

// True if the segment produces the fragment of pixel (x, y).
bool diamond_exit_covers(const Segment& segment, int x, int y, const DiamondBoundary& boundary);

// A diamond of another size round the centre of a pixel: |dx| + |dy| < radius, with the boundary of
// a tie rule. Empty if the radius is not positive.
struct SizedDiamond {
  PixelPosition pixel;
  Fixed radius;
  const TieRule& ties;
};

bool meets(const Segment& segment, const SizedDiamond& diamond);
bool ends_in(const Segment& segment, const SizedDiamond& diamond);

// All pixels within `bounds` that the segment produces, ascending along the major axis.
std::vector<PixelPosition> diamond_exit_pixels(const Segment& segment, const PixelBounds& bounds,
                                               const DiamondBoundary& boundary);

// The pixels within `bounds` for which the ownership of boundaries matters: the segment meets their
// diamond only in its boundary, or ends on it. All DiamondBoundaries agree on other pixels.
// Ascending along the major axis.
std::vector<PixelPosition> tied_line_pixels(const Segment& segment, const PixelBounds& bounds);

// The reason, in a sentence with numbers.
Explanation explain_line(const Segment& segment, int x, int y, const DiamondBoundary& boundary);

}  // namespace edgecase
