// SPDX-License-Identifier: MIT
//
// Joints of lines (GL 4.6 core, 14.5.1, the fourth of the relaxed rules; ruling 14).
//
// A polyline that goes on in one direction must look like one line: no fragment twice, none missing
// where one segment hands over to the next. An algorithm that draws both ends of every segment, or
// neither, may pass every rule on single segments and still fails here.
//
// The letter speaks of any two segments with a common endpoint, both x-major from left to right,
// say. Two that start at one point are such, too, and the diamond-exit rule itself draws their
// first fragment twice; so ruling 14 reads it of one that ends where the other starts.
#pragma once

#include <span>
#include <string>

#include "exact/pixel.h"
#include "rules/coverage/segment.h"
#include "rules/rule.h"

namespace edgecase {

Rule line_joint_rule();

// Does `second` start where `first` ends, with the same major axis and direction, wherever the ends
// lie within `reach`? A segment without length has no direction.
bool goes_on(const Segment& first, const Segment& second, Fixed reach = {});

// A segment of width 1 with the pixels that were drawn of it inside `bounds`, in any order.
struct DrawnSegment {
  Segment segment;
  std::span<const PixelPosition> drawn;
  PixelBounds bounds;
};

// The clause of ruling 14 that two segments break, in words; empty when every clause holds. Both
// must have drawn pixels, and `second` must go on where `first` ends, or where a row of segments
// ends that go on from `first` and drew nothing (`between`, in order). All ends are known to within
// `reach`, see diamond_reach.h.
std::string broken_joint_clause(const DrawnSegment& first, std::span<const Segment> between,
                                const DrawnSegment& second, Fixed reach = {});

}  // namespace edgecase
