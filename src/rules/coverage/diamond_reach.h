// SPDX-License-Identifier: MIT
//
// The diamond-exit rule for a segment whose ends are known to within a reach.
//
// Where a vertex lands may depend on roundings that the specification leaves open (ruling 15). A
// renderer may then draw what the rule has for any place of the ends. No point of the segment moves
// by more than the ends do, so a diamond can only be met by a moved segment if the segment itself
// meets the diamond grown by twice the reach, and is met by every one if it meets the diamond
// shrunk by as much: |dx| + |dy| < 1/2 +- 2 reach. Both bounds are on the safe side; ties do not
// matter to them.
#pragma once

#include <vector>

#include "exact/pixel.h"
#include "rules/coverage/segment.h"

namespace edgecase {

// A segment whose ends lie within `reach` of a and of b, in x and in y. Less than 3/8; 0: the ends
// are known.
struct LooseSegment {
  Segment segment;
  Fixed reach;
};

// Is the segment x-major (y-major) for every place of its ends?
bool surely_x_major(const LooseSegment& loose);
bool surely_y_major(const LooseSegment& loose);

// Within `bounds`, by diamonds as `left-bottom` has them: all fragments that the rule has for some
// place of the ends, and none but such as it has for every place. The same where the ends are
// known.
std::vector<PixelPosition> possible_pixels(const LooseSegment& loose, const PixelBounds& bounds);
std::vector<PixelPosition> certain_pixels(const LooseSegment& loose, const PixelBounds& bounds);

// False only where no place of the ends makes the segment meet the closed diamond of a pixel.
bool may_meet_diamond(const LooseSegment& loose, PixelPosition pixel);

}  // namespace edgecase
