// SPDX-License-Identifier: MIT
//
// Polygon offset (ruling 38): the alternatives of its slope and its unit that yield the depths that
// a renderer reports.
#pragma once

#include "diff/values/value_diff.h"

namespace edgecase {

// True if a polygon offset is added to the fragment's depth.
bool has_offset(const ValueContext& context, const Fragment& fragment);

// The rule on which the fragment's offset depends most: that of a slope, else that of the unit of
// the depth buffer's format.
RuleId offset_rule(const ValueContext& context, const Fragment& fragment);

// The first alternative, or two of different rules, under which the fragment's depth is a result of
// inexact operations; empty if there is none.
Cause cause_of_offset(const ValueContext& context, const Fragment& fragment);

// The alternative that all depths of fragments with an offset follow, if they are permitted and not
// the policy's; without a cause if there is none.
struct FollowedOffset {
  Cause cause;
  RuleId rule = RuleId::fragment_depth;
  int ruling = 9;

  bool explains(const ValueContext& context, const Fragment& fragment) const {
    return !cause.empty() && has_offset(context, fragment);
  }
};
FollowedOffset followed_offset(const ValueContext& context, const Rendering& rendered);

// The unit of polygon offsets, a constant of a fixed-point buffer, that fits most of the fragments
// with reported depths (ruling 38).
Interval followed_fixed_unit(const ValueContext& context, const Rendering& rendered);

}  // namespace edgecase
