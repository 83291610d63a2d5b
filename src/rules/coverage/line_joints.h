// SPDX-License-Identifier: MIT
//
// Joints of lines (GL 4.6 core, 14.5.1, the fourth of the relaxed rules; ruling 14).
//
// Connected segments that run in one direction must look like one line. No fragment is drawn twice,
// and none is missing where one segment ends and the next begins. An algorithm may draw both ends
// of every segment, or neither. It may then obey every rule for single segments and still fail
// here.
//
// The specification speaks of any two segments with a common endpoint and, for example, both
// x-major from left to right. Two segments that start at one point meet that condition. The
// diamond-exit rule itself draws their first fragment twice. Ruling 14 therefore applies the
// sentence only to a segment that ends where the other starts.
#pragma once

#include <span>
#include <string>

#include "exact/fixed.h"
#include "rules/coverage/segment.h"
#include "rules/rule.h"

namespace edgecase {

Rule line_joint_rule();

// True if `second` starts at the end of `first` with the same major axis and direction, for all
// ends within `reach`. A segment without length has no direction.
bool goes_on(const Segment& first, const Segment& second, Fixed reach = {});

// A segment of width 1 with its drawn pixels inside `bounds`, in any order.
struct DrawnSegment {
  Segment segment;
  std::span<const PixelPosition> drawn;
  PixelBounds bounds;
};

// The clause of ruling 14 that two segments break, as text; empty if they satisfy every clause.
// Both must have drawn pixels, and `second` must continue `first`, or a row of segments that
// continue `first` and drew nothing (`between`, in order). All ends are known to within `reach`,
// see line_latitude.h.
std::string broken_joint_clause(const DrawnSegment& first, std::span<const Segment> between,
                                const DrawnSegment& second, Fixed reach = {});

}  // namespace edgecase
