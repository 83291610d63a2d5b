// SPDX-License-Identifier: MIT
//
// Binary32: single-precision arithmetic of IEEE 754, computed in integers.
//
// Some rasterizers decide coverage in single precision. To show that a renderer follows such an
// algorithm, its roundings must be reproduced to the bit on every machine and with every compiler,
// so they are computed here instead of by the processor. Results are rounded to nearest, ties to
// even. The exponent is unbounded: window coordinates and their quotients come nowhere near
// overflow, and numbers that would be subnormal keep all their bits.
#pragma once

#include <bit>
#include <cstdint>

#include "exact/fixed.h"

namespace edgecase {

class Binary32 {
 public:
  static constexpr int kPrecision = 24;  // bits of a significand

  constexpr Binary32() = default;  // zero
  static constexpr Binary32 from_integer(std::int64_t value) { return rounded(value, 0); }
  // The nearest single-precision number; exact for |value| < 2^8 pixels.
  static constexpr Binary32 from_fixed(Fixed value) {
    return rounded(value.raw(), -Fixed::kFractionBits);
  }

  friend constexpr Binary32 operator+(Binary32 a, Binary32 b) {
    // A number too small to reach the last bit is replaced by its sign, far below that bit.
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    if (a.exponent_ < b.exponent_) return b + a;
    const int shift = a.exponent_ - b.exponent_;
    constexpr int kNear = 62 - kPrecision;  // a sum that fits
    if (shift < kNear) return rounded((a.significand_ << shift) + b.significand_, b.exponent_);
    constexpr int kFar = 2 * kPrecision + 2;
    if (shift > kFar)
      return rounded((static_cast<Int128>(a.significand_) << kFar) + sign(b.significand_),
                     a.exponent_ - kFar);
    return rounded((static_cast<Int128>(a.significand_) << shift) + b.significand_, b.exponent_);
  }
  friend constexpr Binary32 operator-(Binary32 a) {
    a.significand_ = -a.significand_;
    return a;
  }
  friend constexpr Binary32 operator-(Binary32 a, Binary32 b) { return a + -b; }
  friend constexpr Binary32 operator*(Binary32 a, Binary32 b) {
    return rounded(a.significand_ * b.significand_, a.exponent_ + b.exponent_);
  }
  // b must not be zero.
  friend constexpr Binary32 operator/(Binary32 a, Binary32 b) {
    // Two bits more than needed, and a last one that is set if there is a remainder.
    constexpr int kShift = 2 * kPrecision + 2;
    const Int128 dividend = static_cast<Int128>(a.significand_) << kShift;
    const Int128 quotient = dividend / b.significand_;
    const Int128 rest = dividend % b.significand_;
    const Int128 sticky = rest == 0 ? 0 : sign(dividend) * sign(b.significand_);
    return rounded(2 * quotient + sticky, a.exponent_ - b.exponent_ - kShift - 1);
  }
  friend constexpr bool operator==(Binary32, Binary32) = default;

  constexpr bool is_zero() const { return significand_ == 0; }
  constexpr bool is_negative() const { return significand_ < 0; }

  // Largest integer not above the number, smallest not below it, and the next one toward zero. The
  // magnitude must be below 2^62.
  constexpr std::int64_t floor() const {
    if (exponent_ >= 0) return significand_ << exponent_;
    return exponent_ < -62 ? (significand_ < 0 ? -1 : 0) : significand_ >> -exponent_;
  }
  constexpr std::int64_t ceil() const { return -(-*this).floor(); }
  constexpr std::int64_t truncate() const { return significand_ < 0 ? ceil() : floor(); }

 private:
  // value * 2^exponent, rounded.
  template <class Integer>
  static constexpr Binary32 rounded(Integer value, int exponent) {
    Integer magnitude = value < 0 ? -value : value;
    const int width = width_of(magnitude);
    const int dropped = width > kPrecision ? width - kPrecision : 0;
    if (dropped > 0) {
      const Integer half = Integer{1} << (dropped - 1);
      const Integer rest = magnitude & ((Integer{1} << dropped) - 1);
      magnitude >>= dropped;
      if (rest > half || (rest == half && (magnitude & 1) != 0)) ++magnitude;
    }
    return normalised(static_cast<std::int64_t>(value < 0 ? -magnitude : magnitude),
                      exponent + dropped);
  }

  static constexpr int width_of(std::int64_t magnitude) {
    return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(magnitude)));
  }
  static constexpr int width_of(Int128 magnitude) {
    const auto high = static_cast<std::int64_t>(magnitude >> 64);
    return high != 0 ? 64 + width_of(high) : width_of(static_cast<std::int64_t>(magnitude));
  }

  // Each number has one representation: an odd significand, or zero.
  static constexpr Binary32 normalised(std::int64_t significand, int exponent) {
    Binary32 result;
    if (significand == 0) return result;
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(significand));
    result.significand_ = significand >> zeros;
    result.exponent_ = exponent + zeros;
    return result;
  }

  std::int64_t significand_ = 0;  // at most 2^24 in magnitude
  int exponent_ = 0;
};

}  // namespace edgecase
