// SPDX-License-Identifier: MIT
//
// Finds the alternative of the rules on values that yields a fragment's value, if that is beyond
// what the specification permits.
#pragma once

#include <array>

#include "diff/values/value_diff.h"
#include "rules/choices.h"
#include "rules/values/attributes.h"

namespace edgecase {

bool is_by_major_axis(const Cause& cause);

// The first alternative of attribute.smooth, attribute.perspective and attribute.positions that
// yields every component with inexact operations; for colours, if there is none, the first two of
// how and where they are interpolated. No cause if there is none.
Cause cause_of_color(const ValueContext& context, const Fragment& fragment);
Cause cause_of_depth(const ValueContext& context, const Fragment& fragment);
Cause cause_of_inverse_w(const ValueContext& context, const Fragment& fragment, double inverse_w);

// The same for derivatives of the colour along x and y, both by any one method.
Cause cause_of_derivatives(const ValueContext& context, const Fragment& fragment,
                           const FragmentDetail& detail, const std::array<Derivative, 2>& along);

// The fragment's place in its quad, under the policy.
QuadPixel quad_place(const ValueContext& context, const Fragment& fragment);

// True if a method, every operation inexact, yields these derivatives of a colour's components.
bool yields_derivative(const std::array<Interpolant, 4>& color, const QuadPixel& at,
                       Derivative derivative, DerivativeMethod method,
                       const std::array<double, 4>& rendered);

// --------------------------------------------------------------------------------------- locations
//
// Other locations at which a renderer evaluates the attributes of multisampled draws: the choice
// that the specification leaves open, found from all fragments of a case together.

// Where attributes and depths are evaluated under a change.
LocationChoice locations_of(const Change& change, const RuleChoices& chosen);

// The location at which all smooth colours of a case are evaluated, if the policy's own choice does
// not yield them; without a cause if there is none.
struct FollowedLocation {
  Cause cause;
  RuleId rule = RuleId::attribute_smooth;
  int ruling = kRulingOnInterpolation;

  // True if this location yields the fragment's colour and the policy's does not.
  bool explains(const ValueContext& context, const Fragment& fragment) const;
};

FollowedLocation followed_location(const ValueContext& context, const Rendering& rendered);

// The same for gl_FragCoord.z.
struct FollowedDepth {
  Cause cause;
  RuleId rule = RuleId::fragment_depth;
  int ruling = kRulingOnInterpolation;

  bool explains(const ValueContext& context, const Fragment& fragment) const;
};

FollowedDepth followed_depth(const ValueContext& context, const Rendering& rendered);

// True if a primitive with this depth has the fragment's gl_FragCoord.z where a choice evaluates
// it.
bool yields_depth(const ValueContext& context, const Fragment& fragment, const Interpolant& depth,
                  const LocationChoice& choice);

// Polygon offset (ruling 38): the alternatives of its slope and its unit that yield the depths that
// a renderer reports.

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

// The unit of polygon offsets, a constant of a fixed-point buffer (rulings 38 and 64).
struct FollowedUnit {
  Interval unit;  // that fits most of the fragments with reported depths
  // What primitives show of it, of each one interval. Where all vertices of one have the same
  // depth, so have its fragments before the offset, to 8 units in the last place of float32, or to
  // a step of the buffer where the depth is one of its values.
  std::vector<Interval> shown;
};
FollowedUnit followed_fixed_unit(const ValueContext& context, const Rendering& rendered);

}  // namespace edgecase
