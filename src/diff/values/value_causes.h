// SPDX-License-Identifier: MIT
//
// Which alternative of the rules on values yields what a fragment has, where that is beyond what
// the specification permits.
#pragma once

#include <array>

#include "diff/values/value_diff.h"
#include "rules/changes.h"

namespace edgecase {

// The ruling on values of a line that go by its major axis, or are those of another fragment of a
// wide line's column.
inline constexpr int kRulingOnLineValues = 46;
bool is_by_major_axis(const Cause& cause);

// The first alternative of attribute.smooth, attribute.perspective and attribute.positions under
// which every component is what comes of inexact operations; of colours, where none is, the first
// two of how and where they are interpolated. No cause where none is.
Cause cause_of_color(const ValueContext& context, const Fragment& fragment);
Cause cause_of_depth(const ValueContext& context, const Fragment& fragment);
Cause cause_of_inverse_w(const ValueContext& context, const Fragment& fragment, double inverse_w);

// The same of derivatives of the colour along x and y, both by one method, whichever.
Cause cause_of_derivatives(const ValueContext& context, const Fragment& fragment,
                           const FragmentDetail& detail, const std::array<Derivative, 2>& along);

// The fragment's place in its quad, under the policy.
QuadPixel quad_place(const ValueContext& context, const Fragment& fragment);

// Does a method, every operation inexact, yield these derivatives of a colour's components?
bool yields_derivative(const std::array<Interpolant, 4>& color, const QuadPixel& at,
                       Derivative derivative, DerivativeMethod method,
                       const std::array<double, 4>& rendered);

// --------------------------------------------------------------------------------------- locations
//
// Where else a renderer evaluates the attributes of multisampled draws: the choice that the
// specification leaves open, read off all fragments of a case together.

// Every alternative of where attributes but depth are evaluated, beside what is chosen.
Changes location_changes(const RuleChoices& chosen);

// Where they and depths are evaluated under a change.
LocationChoice locations_of(const Change& change, const RuleChoices& chosen);

// What all smooth colours of a case are evaluated by, where the policy's own choice does not yield
// them; without a cause where there is no such thing.
struct FollowedLocation {
  Cause cause;
  RuleId rule = RuleId::attribute_smooth;
  int ruling = 9;

  // Is the fragment's colour another than the policy's place yields, and has it so?
  bool explains(const ValueContext& context, const Fragment& fragment) const;
};

FollowedLocation followed_location(const ValueContext& context, const Rendering& rendered);

// The same of gl_FragCoord.z.
struct FollowedDepth {
  Cause cause;
  RuleId rule = RuleId::fragment_depth;
  int ruling = 9;

  bool explains(const ValueContext& context, const Fragment& fragment) const;
};

FollowedDepth followed_depth(const ValueContext& context, const Rendering& rendered);

// Does a primitive with this depth have gl_FragCoord.z so where a choice evaluates it?
bool yields_depth(const ValueContext& context, const Fragment& fragment, const Interpolant& depth,
                  const LocationChoice& choice);

}  // namespace edgecase
