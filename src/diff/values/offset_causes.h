// SPDX-License-Identifier: MIT
//
// Polygon offset (ruling 38): the alternatives of its slope and its unit that yield the depths that
// a renderer reports.
#pragma once

#include <vector>

#include "diff/values/value_diff.h"
#include "exact/interval.h"
#include "rules/values/attributes.h"

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
  int ruling = kRulingOnInterpolation;

  bool explains(const ValueContext& context, const Fragment& fragment) const {
    return !cause.empty() && has_offset(context, fragment);
  }
};
FollowedOffset followed_offset(const ValueContext& context, const Rendering& rendered);

// The unit of polygon offsets in a fixed-point depth buffer (rulings 38 and 64). It is one
// constant, which the implementation does not report. Each fragment with a reported depth leaves an
// interval of units that may have led to it; the unit is assumed to lie where most of these
// intervals meet. If they do not all meet, the fragments of the others are the faulty ones.
struct FollowedUnit {
  Interval unit;  // that fits most of the fragments with reported depths
  // What primitives show of it, of each one interval. Where all vertices of one have the same
  // depth, so have its fragments before the offset, to 8 units in the last place of float32, or to
  // a step of the buffer where the depth is one of its values.
  std::vector<Interval> shown;
};
FollowedUnit followed_fixed_unit(const ValueContext& context, const Rendering& rendered);

}  // namespace edgecase
