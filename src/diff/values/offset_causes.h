// SPDX-License-Identifier: MIT
//
// Polygon offset (ruling 38): which alternatives of its slope and its unit yield the depths that a
// renderer tells.
#pragma once

#include "diff/values/value_diff.h"

namespace edgecase {

// Is a polygon offset added to the fragment's depth?
bool has_offset(const ValueContext& context, const Fragment& fragment);

// The rule that the fragment's offset depends on most: of a slope, else of the unit of the depth
// buffer's format.
RuleId offset_rule(const ValueContext& context, const Fragment& fragment);

// The first alternative, or two of different rules, under which the fragment's depth is what comes
// of inexact operations; empty: none is.
Cause cause_of_offset(const ValueContext& context, const Fragment& fragment);

// What the depths of all fragments with an offset follow, where they are permitted and not the
// policy's; without a cause where there is no such thing.
struct FollowedOffset {
  Cause cause;
  RuleId rule = RuleId::fragment_depth;
  int ruling = 9;

  bool explains(const ValueContext& context, const Fragment& fragment) const {
    return !cause.empty() && has_offset(context, fragment);
  }
};
FollowedOffset followed_offset(const ValueContext& context, const Rendering& rendered);

// The unit of polygon offsets that most of the fragments can have whose depths are told: a constant
// of a fixed-point buffer (ruling 38).
Interval followed_fixed_unit(const ValueContext& context, const Rendering& rendered);

}  // namespace edgecase
