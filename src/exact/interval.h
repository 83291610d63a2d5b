// SPDX-License-Identifier: MIT
//
// Interval: a closed range of reals with double ends, rounded outwards.
//
// Coverage never uses it. Values do: it bounds what a formula may yield when its inputs are ranges
// (vertices that may be snapped) and when each operation may err by a relative amount (the
// floating-point clause of the specification, GL 4.6 core, 2.3, "about 1 part in 10^5").
#pragma once

namespace edgecase {

struct Interval {
  double low = 0;
  double high = 0;

  constexpr Interval() = default;
  constexpr Interval(double value) : low(value), high(value) {}  // NOLINT: a number is an interval
  constexpr Interval(double low_end, double high_end) : low(low_end), high(high_end) {}

  // The whole line: nothing is known.
  static Interval everything();

  constexpr bool contains(double value) const { return low <= value && value <= high; }
  double magnitude() const;  // largest absolute value
};

Interval operator+(Interval a, Interval b);
Interval operator-(Interval a, Interval b);
Interval operator*(Interval a, Interval b);
// Everything when b holds zero.
Interval operator/(Interval a, Interval b);

// The smallest interval that holds both.
Interval hull(Interval a, Interval b);

// Grown at each end by `relative` times the magnitude: the result of one operation that may err by
// that much.
Interval widened(Interval value, double relative);

}  // namespace edgecase
