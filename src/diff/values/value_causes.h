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

// The rules of where attributes are evaluated.
inline constexpr RuleId kLocationRules[] = {RuleId::attribute_location, RuleId::attribute_centroid};

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

// Where attributes and depths are evaluated under a change.
LocationChoice locations_of(const Change& change, const RuleChoices& chosen);

// True if a primitive with these attributes has the fragment's colour at a place in the window, or,
// with this depth, its gl_FragCoord.z where a choice evaluates it.
bool yields_color(const PrimitiveAttributes& attributes, Point place, const Fragment& fragment);
bool yields_depth(const ValueContext& context, const Fragment& fragment, const Interpolant& depth,
                  const LocationChoice& choice);

// True if a method, every operation inexact, yields these derivatives of a colour's components.
bool yields_derivative(const std::array<Interpolant, 4>& color, const QuadPixel& at,
                       Derivative derivative, DerivativeMethod method,
                       const std::array<double, 4>& rendered);

}  // namespace edgecase
