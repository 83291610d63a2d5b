// SPDX-License-Identifier: MIT
//
// Lines of width 1: the diamond-exit rule (GL 4.6 core, 14.5.1).
//
// Round every pixel centre lies an open diamond, |dx| + |dy| < 1/2. A segment from a to b produces
// the fragment of each diamond that it meets, except the one that contains b: the segment must exit
// it. Both ends are first moved by -(e, e^2), so that nothing depends on what happens exactly on a
// diamond's boundary. We move the diamond by +(e, e^2) instead, which is tie rule `left-bottom`.
//
// In rotated coordinates u = x + y, v = x - y the diamond is an open square with sides parallel to
// the axes, and a segment meets an open convex set unless one of three directions separates them:
// u, v, or the segment's normal. That makes six linear functions of the sample that must all be
// positive; a seventh to tenth say whether b lies inside. No square roots, no division, no
// rounding.
#pragma once

#include <vector>

#include "exact/fixed.h"
#include "exact/pixel.h"
#include "rules/coverage/diamond_boundary.h"
#include "rules/coverage/explain.h"
#include "rules/coverage/segment.h"
#include "rules/rule.h"

namespace edgecase {

Rule diamond_exit_rule();
Rule interior_gap_rule();

// Does the segment meet the diamond of pixel (x, y)?
bool meets_diamond(const Segment& segment, int x, int y, const DiamondBoundary& boundary);

// Does the diamond of pixel (x, y) contain the end of the segment?
bool ends_in_diamond(const Segment& segment, int x, int y, const DiamondBoundary& boundary);

// Does the segment produce the fragment of pixel (x, y)?
bool diamond_exit_covers(const Segment& segment, int x, int y, const DiamondBoundary& boundary);

// A diamond of another size round the centre of a pixel: |dx| + |dy| < radius, its boundary as a
// tie rule has it. Without a positive radius it is empty.
struct SizedDiamond {
  PixelPosition pixel;
  Fixed radius;
  const TieRule& ties;
};

bool meets(const Segment& segment, const SizedDiamond& diamond);
bool ends_in(const Segment& segment, const SizedDiamond& diamond);

// All pixels within `bounds` that the segment produces, along the major axis in ascending order.
std::vector<PixelPosition> diamond_exit_pixels(const Segment& segment, const PixelBounds& bounds,
                                               const DiamondBoundary& boundary);

// The pixels within `bounds` at which it matters whom boundaries belong to: the segment meets their
// diamond in its boundary alone, or ends on it. At others all DiamondBoundaries decide alike. Along
// the major axis in ascending order.
std::vector<PixelPosition> tied_line_pixels(const Segment& segment, const PixelBounds& bounds);

// Why, in a sentence with numbers.
Explanation explain_line(const Segment& segment, int x, int y, const DiamondBoundary& boundary);

}  // namespace edgecase
