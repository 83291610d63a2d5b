// SPDX-License-Identifier: MIT
//
// Rational: an exact quotient of integers of unbounded size.
//
// Intervals answer nearly every question about values. Some questions are yes-or-no with the exact
// number on the border: which texel holds a point, which level a scale factor selects. Those are
// answered here. This is slow (a microsecond where an interval takes a nanosecond), and its header
// adds seconds to each compilation, so include it only where needed.
#pragma once

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "exact/fixed.h"
#include "exact/interval.h"

namespace edgecase {

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;
// For exact decisions whose products exceed 128 bits by a bounded amount.
using Int256 = boost::multiprecision::int256_t;

inline Integer integer_of(Int128 value) {
  return Integer(value);
}

// above / below, for a denominator of either sign but not 0; the constructor needs a positive one.
inline Rational quotient_of(const Integer& above, const Integer& below) {
  return below < 0 ? Rational(Integer(-above), Integer(-below)) : Rational(above, below);
}

// 2^exponent, for an exponent of either sign.
inline Rational power_of_two(int exponent) {
  const Integer power = Integer(1) << std::abs(exponent);
  return exponent < 0 ? Rational(Integer(1), power) : Rational(power);
}

// The exact value of a finite number.
inline Rational rational_of(double value) {
  if (value == 0) return 0;
  int exponent = 0;
  auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  exponent -= 53;
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(digits));
  digits >>= zeros;
  exponent += zeros;
  if (exponent >= 0) return Rational(Integer(digits) << exponent);
  return Rational(Integer(digits), Integer(1) << -exponent);
}
inline Rational rational_of(float value) {
  return rational_of(static_cast<double>(value));
}
inline Rational rational_of(Int128 value) {
  return Rational(integer_of(value));
}

// The largest integer not above the number.
inline Integer floor_of(const Rational& value) {
  Integer quotient, rest;
  divide_qr(numerator(value), denominator(value), quotient, rest);
  if (rest < 0) --quotient;
  return quotient;
}

inline bool is_whole(const Rational& value) {
  return denominator(value) == 1;
}

// A quotient of machine integers, not reduced: below more than 0, and small enough for
// interval_of() where is_small() says so.
struct MachineQuotient {
  Int128 above = 0;
  Int128 below = 1;
  // |above| below 2^120, below under 2^73.
  bool is_small() const {
    constexpr Int128 kAbove = Int128{1} << 120;
    return -kAbove < above && above < kAbove && below < Int128{1} << 73;
  }
};

// The number of digits of a positive number in base 2.
inline int digits_of(Int128 value) {
  const auto high = static_cast<std::uint64_t>(value >> 64);
  return 128 - (high != 0 ? std::countl_zero(high)
                          : 64 + std::countl_zero(static_cast<std::uint64_t>(value)));
}

// The narrowest interval that holds the number: a point if it is a double, otherwise two
// neighbours, the outer of which may be infinite.
inline Interval interval_of(const MachineQuotient& value) {
  if (value.above < 0) {
    const Interval positive = interval_of(MachineQuotient{-value.above, value.below});
    return {-positive.high, -positive.low};
  }
  if (value.above == 0) return 0;
  // 53 or 54 digits before the point.
  const int scale = 53 + digits_of(value.below) - digits_of(value.above);
  const Int128 above = value.above << std::max(scale, 0);
  const Int128 below = value.below << std::max(-scale, 0);
  const auto digits = static_cast<std::int64_t>(above / below);
  const int spare = digits >> 53 != 0 ? 1 : 0;
  const std::int64_t kept = digits >> spare;
  const double low = std::ldexp(static_cast<double>(kept), spare - scale);
  const bool is_exact = Int128{kept << spare} * below == above;
  return is_exact ? Interval(low) : Interval(low, next_above(low));
}

inline Interval interval_of(const Rational& value) {
  if (value < 0) {
    const Interval positive = interval_of(Rational(-value));
    return {-positive.high, -positive.low};
  }
  if (value == 0) return 0;
  const Integer above = numerator(value), below = denominator(value);
  if (msb(above) < 120 && msb(below) < 73)
    return interval_of(MachineQuotient{static_cast<Int128>(above), static_cast<Int128>(below)});
  // At least 53 digits before the point; digits below the smallest double are cut off.
  const int scale =
      std::min(53 + static_cast<int>(msb(below)) - static_cast<int>(msb(above)), 1074);
  Integer digits, rest;
  divide_qr(Integer(above << std::max(scale, 0)), Integer(below << std::max(-scale, 0)), digits,
            rest);
  const int spare = digits == 0 ? 0 : std::max(static_cast<int>(msb(digits)) - 52, 0);
  const auto kept = static_cast<std::int64_t>(digits >> spare);
  const bool is_exact = rest == 0 && (Integer(kept) << spare) == digits;
  const double low = std::ldexp(static_cast<double>(kept), spare - scale);
  if (std::isinf(low)) return {std::numeric_limits<double>::max(), low};
  return is_exact ? Interval(low) : Interval(low, next_above(low));
}

}  // namespace edgecase
