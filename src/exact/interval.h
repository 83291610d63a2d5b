// SPDX-License-Identifier: MIT
//
// Interval: a closed range of reals with double ends, rounded outwards.
//
// Coverage never uses it. Values do: it bounds the result of a formula whose inputs are ranges
// (vertices that may be snapped) and whose operations may each err by a relative amount (the
// floating-point clause of the specification, GL 4.6 core, 2.3, "about 1 part in 10^5").
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "exact/fixed.h"

namespace edgecase {

// The next double above and below a double, as std::nextafter with an infinity, but inline: outward
// rounding needs one for each end of each operation, and calls into the C library took half of the
// time of judging values.

// The smallest double above; infinity stays infinity. The value must not be NaN.
inline double next_above(double value) {
  constexpr auto kInfinity = std::bit_cast<std::int64_t>(std::numeric_limits<double>::infinity());
  // Doubles of one sign are ordered like their bits; adding zero turns -0 into +0.
  const auto bits = std::bit_cast<std::int64_t>(value + 0.0);
  if (bits == kInfinity) return value;
  return std::bit_cast<double>(bits < 0 ? bits - 1 : bits + 1);
}

// The largest double below; minus infinity stays minus infinity. The value must not be NaN.
inline double next_below(double value) {
  return -next_above(-value);
}

struct Interval {
  double low = 0;
  double high = 0;

  constexpr Interval() = default;
  constexpr Interval(double value) : low(value), high(value) {}  // NOLINT: a number is an interval
  constexpr Interval(double low_end, double high_end) : low(low_end), high(high_end) {}

  // The whole real line: the value is unknown.
  static constexpr Interval everything() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {-kInfinity, kInfinity};
  }

  constexpr bool contains(double value) const { return low <= value && value <= high; }
  friend constexpr bool operator==(const Interval&, const Interval&) = default;
  // Largest absolute value.
  double magnitude() const { return std::max(std::fabs(low), std::fabs(high)); }
};

// One unit in the last place outwards covers the half unit by which the hardware may have rounded.
// If an end is NaN, the result is the whole line.
inline Interval outward(double low, double high) {
  if (std::isunordered(low, high)) return Interval::everything();
  return {next_below(low), next_above(high)};
}

// The smallest interval, rounded outwards, that holds all four numbers.
inline Interval outward(double a, double b, double c, double d) {
  if (std::isunordered(a, b) || std::isunordered(c, d)) return Interval::everything();
  return {next_below(std::min(std::min(a, b), std::min(c, d))),
          next_above(std::max(std::max(a, b), std::max(c, d)))};
}

// A point up to 2^53, where double holds every integer.
inline Interval interval_of(Int128 value) {
  constexpr Int128 kLimit = Int128{1} << 53;
  // 64 bits take one instruction, 128 a call of the compiler's library; both round to nearest.
  const auto half = static_cast<std::int64_t>(value);
  const auto nearest = half == value ? static_cast<double>(half) : static_cast<double>(value);
  if (-kLimit <= value && value <= kLimit) return nearest;
  return outward(nearest, nearest);
}

inline Interval operator+(Interval a, Interval b) {
  return outward(a.low + b.low, a.high + b.high);
}

inline Interval operator-(Interval a, Interval b) {
  return outward(a.low - b.high, a.high - b.low);
}

inline Interval operator*(Interval a, Interval b) {
  return outward(a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high);
}

// The whole line if b contains zero.
inline Interval operator/(Interval a, Interval b) {
  if (b.contains(0)) return Interval::everything();
  return outward(a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high);
}

// The smallest interval that holds both.
inline Interval hull(Interval a, Interval b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

// Grown at each end by `relative` times the magnitude: the result of an operation with that
// relative error.
inline Interval widened(Interval value, double relative) {
  // Rounded up: if an end cancels against the margin, only the margin's own error remains.
  const double margin = next_above(value.magnitude() * relative);
  return outward(value.low - margin, value.high + margin);
}

// The nearest float32 value.
inline double to_float(double value) {
  return static_cast<double>(static_cast<float>(value));
}

// Correct rounding is monotonic, so the roundings of the interval's ends enclose that of the value.
inline Interval rounded_to_float(Interval value) {
  return {to_float(value.low), to_float(value.high)};
}

}  // namespace edgecase
