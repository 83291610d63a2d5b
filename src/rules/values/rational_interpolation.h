// SPDX-License-Identifier: MIT
//
// Interpolation without rounding: the values of rules/values/interpolation.h as quotients of
// integers, for the few questions that an interval leaves open.
//
// Weights are linear in the sample, so the value is the quotient of two linear forms in its
// coordinates, whose integer coefficients are computed once for a primitive.
#pragma once

#include <optional>

#include "exact/rational.h"
#include "rules/values/derivative.h"
#include "rules/values/interpolation.h"

namespace edgecase {

class RationalInterpolation {
 public:
  // None where the primitive has no extent, or a value is no single finite number.
  static std::optional<RationalInterpolation> of(const Interpolant& interpolant);

  // The value at a sample, which may lie outside the primitive; none where its denominator is 0,
  // on the line of the window where all that the primitive's plane shows is infinitely far away.
  std::optional<Rational> at(Point sample) const;

  // Per pixel; none where one of the values it is made of is none.
  std::optional<Rational> derivative(const QuadPixel& at, Axis axis, DerivativeMethod method) const;

 private:
  // x sample.x + y sample.y + one, the sample's coordinates being multiples of 2^-16.
  struct Form {
    Integer x;
    Integer y;
    Integer one;
    Integer at(Point sample) const { return x * sample.x.raw() + y * sample.y.raw() + one; }
  };
  RationalInterpolation() = default;
  Rational slope(Point sample, Axis axis, const Integer& below) const;

  Form above_;
  Form below_;
};

// The same of one sample, as interpolate_exact and derivative_exact.
std::optional<Rational> interpolate_rational(const Interpolant& interpolant, Point sample);
std::optional<Rational> derivative_rational(const Interpolant& interpolant, const QuadPixel& at,
                                            Axis axis, DerivativeMethod method);

}  // namespace edgecase
