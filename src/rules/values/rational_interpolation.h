// SPDX-License-Identifier: MIT
//
// Interpolation without rounding: the values of rules/values/interpolation.h as quotients of
// integers, for the few questions that an interval does not decide.
//
// Weights are linear in the sample, so the value is the quotient of two linear forms in its
// coordinates, with integer coefficients that are computed once for a primitive.
#pragma once

#include <optional>

#include "exact/rational.h"
#include "rules/values/derivative.h"
#include "rules/values/interpolation.h"

namespace edgecase {

class RationalInterpolation {
 public:
  // None if the primitive has no extent, or a value is not a single finite number.
  static std::optional<RationalInterpolation> of(const Interpolant& interpolant);

  // The value at a sample, which may lie outside the primitive; none if its denominator is 0, on
  // the line of the window where the primitive's plane is infinitely far away.
  std::optional<Rational> at(Point sample) const;

  // The same as a quotient of machine integers; none if there is none, or if it is not small.
  std::optional<MachineQuotient> quotient_at(Point sample) const;

  // Per pixel; none if one of the values needed is none.
  std::optional<Rational> derivative(const QuadPixel& at, Axis axis, DerivativeMethod method) const;

 private:
  // x sample.x + y sample.y + one, the sample's coordinates being multiples of 2^-16.
  template <class Number>
  struct Form {
    Number x = 0, y = 0, one = 0;
    Number at(Point sample) const { return x * sample.x.raw() + y * sample.y.raw() + one; }
  };
  using MachineForm = Form<Int128>;  // in machine integers below 2^62
  static std::optional<MachineForm> small(const Form<Integer>& form);
  RationalInterpolation() = default;
  Rational slope(Point sample, Axis axis, const Integer& below) const;

  Form<Integer> above_, below_;
  std::optional<MachineForm> machine_above_, machine_below_;  // none: too large
};

// That of one interpolant, made on first use.
class LazyRational {
 public:
  const std::optional<RationalInterpolation>& of(const Interpolant& interpolant) {
    if (!made_) made_ = RationalInterpolation::of(interpolant);
    return *made_;
  }

 private:
  std::optional<std::optional<RationalInterpolation>> made_;
};

// The same for one sample, like interpolate_exact and derivative_exact.
std::optional<Rational> interpolate_rational(const Interpolant& interpolant, Point sample);
std::optional<Rational> derivative_rational(const Interpolant& interpolant, const QuadPixel& at,
                                            Axis axis, DerivativeMethod method);

}  // namespace edgecase
