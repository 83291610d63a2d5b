// SPDX-License-Identifier: MIT
//
// Arithmetic of doubles rounded down or rounded up, in which exact results stay exact.
//
// Levels of detail depend on exact numbers: a footprint of 2 by 0 texels has the length 2 and the
// level 1, and exactly there it is decided which texture is magnified and which level is nearest.
// Intervals that grow at every operation (exact/interval.h) would make each such case uncertain.
// Here the error of an operation is found without rounding, by the sums of Knuth and by fused
// multiplication, and an end moves only if there is an error.
//
// Operands must not be NaN. If a result is so small that its error is no double, the end moves.
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "exact/interval.h"

namespace edgecase {

// Below this, the error of a product may be lost; from here on it is a double.
constexpr double kLeastProduct = 0x1p-960;

struct Down {
  static double sum(double a, double b) {
    const double nearest = a + b;
    if (std::isinf(a) || std::isinf(b)) return nearest;
    const double b_part = nearest - a;
    const double error = (a - (nearest - b_part)) + (b - b_part);
    return error >= 0 ? nearest : next_below(nearest);
  }

  static double product(double a, double b) {
    if (a == 0 || b == 0) return 0;
    const double nearest = a * b;
    if (std::isinf(a) || std::isinf(b)) return nearest;
    const bool exact_error = std::fabs(nearest) >= kLeastProduct;
    return exact_error && std::fma(a, b, -nearest) >= 0 ? nearest : next_below(nearest);
  }

  // 0 or more, divided by more than 0.
  static double quotient(double a, double b) {
    if (a == 0 || std::isinf(a)) return a;
    const double nearest = a / b;
    const bool exact_error = a >= kLeastProduct;
    return exact_error && std::fma(nearest, b, -a) <= 0 ? nearest : next_below(nearest);
  }

  // The root of 0 or more. IEEE 754 rounds it correctly.
  static double root(double a) {
    if (a == 0 || std::isinf(a)) return a;
    const double nearest = std::sqrt(a);
    const bool exact_error = a >= kLeastProduct;
    return exact_error && std::fma(nearest, nearest, -a) <= 0 ? nearest : next_below(nearest);
  }
};

struct Up {
  static double sum(double a, double b) { return -Down::sum(-a, -b); }
  static double product(double a, double b) { return -Down::product(-a, b); }

  static double quotient(double a, double b) {
    if (a == 0 || std::isinf(a)) return a;
    const double nearest = a / b;
    const bool exact_error = a >= kLeastProduct;
    return exact_error && std::fma(nearest, b, -a) >= 0 ? nearest : next_above(nearest);
  }

  static double root(double a) {
    if (a == 0 || std::isinf(a)) return a;
    const double nearest = std::sqrt(a);
    const bool exact_error = a >= kLeastProduct;
    return exact_error && std::fma(nearest, nearest, -a) >= 0 ? nearest : next_above(nearest);
  }
};

// The length of a vector: its components are 0 or more.
template <class Rounding>
double root_of_squares(std::initializer_list<double> components) {
  double squares = 0;
  for (const double component : components)
    squares = Rounding::sum(squares, Rounding::product(component, component));
  return Rounding::root(std::max(squares, 0.0));
}

inline Interval exact_sum(Interval a, Interval b) {
  return {Down::sum(a.low, b.low), Up::sum(a.high, b.high)};
}

// The factor is 0 or more.
inline Interval exact_product(Interval a, double factor) {
  return {Down::product(a.low, factor), Up::product(a.high, factor)};
}

// An end that is NaN means that nothing is known on its side.
inline Interval known(Interval value) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (std::isnan(value.low)) value.low = -kInfinity;
  if (std::isnan(value.high)) value.high = kInfinity;
  return value;
}

// The assumed error of exact/elementary.h's functions, in doubles. glibc documents errors of its
// functions of long doubles of a few units (its manual, Known Maximum Errors in Math Functions).
constexpr int kPlacesOfLibrary = 4;

// Grown by this many doubles at each end.
inline Interval around(double value, int places) {
  Interval result = value;
  for (int i = 0; i < places; ++i) result = {next_below(result.low), next_above(result.high)};
  return result;
}

// The absolute values.
inline Interval magnitudes(Interval value) {
  const double low = value.contains(0) ? 0 : std::min(std::fabs(value.low), std::fabs(value.high));
  return {low, value.magnitude()};
}

}  // namespace edgecase
