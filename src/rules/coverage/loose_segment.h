// SPDX-License-Identifier: MIT
//
// Segments whose ends are known to within a reach.
//
// The position of a vertex may depend on roundings that the specification leaves open (ruling 15).
// A renderer may then draw the rule's fragments for any ends within reach. No point of the segment
// moves farther than the ends do, so a diamond can only be met by a moved segment if the segment
// itself meets the diamond grown by twice the reach, and every moved segment meets it if the
// segment meets the diamond shrunk by as much: |dx| + |dy| < 1/2 +- 2 reach. Both bounds are on the
// safe side; ties do not matter to them.
#pragma once

#include <vector>

#include "exact/fixed.h"
#include "rules/coverage/segment.h"

namespace edgecase {

// A segment whose ends lie within `reach` of a and of b, in x and in y. Less than 3/8; 0: the ends
// are known.
struct LooseSegment {
  Segment segment;
  Fixed reach;
};

// True if the segment is x-major (y-major) for all ends within reach.
bool surely_x_major(const LooseSegment& loose);
bool surely_y_major(const LooseSegment& loose);

// Within `bounds`, with diamonds as in `left-bottom`: all fragments of the rule for some ends
// within reach, and only those for all ends. The two are the same if the ends are known.
std::vector<PixelPosition> possible_pixels(const LooseSegment& loose, const PixelBounds& bounds);
std::vector<PixelPosition> certain_pixels(const LooseSegment& loose, const PixelBounds& bounds);

// False only if no ends within reach make the segment meet the closed diamond of a pixel.
bool may_meet_diamond(const LooseSegment& loose, PixelPosition pixel);

}  // namespace edgecase
