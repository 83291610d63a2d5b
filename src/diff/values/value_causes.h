// SPDX-License-Identifier: MIT
//
// Which alternative of the rules on values yields what a fragment has, where that is beyond what
// the specification permits.
#pragma once

#include <array>

#include "diff/values/value_diff.h"

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

}  // namespace edgecase
