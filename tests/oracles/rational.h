// SPDX-License-Identifier: MIT
//
// Rational: exact fractions of 128-bit integers, for oracles.
//
// Slow and obvious: add, subtract, multiply, divide, compare. A fraction is brought to lowest terms
// when it grows beyond 62 bits, not before, because most scenes never get there. An operation whose
// result leaves 128 bits stops the program: an oracle may be slow, but never wrong.
#pragma once

#include <cstdint>
#include <cstdlib>

#include "exact/fixed.h"

namespace edgecase::oracle {

class Rational {
 public:
  Rational() = default;
  Rational(int value) : top_(value) {}  // implicit: whole numbers are fractions
  Rational(Int128 top, Int128 bottom) : top_(top), bottom_(bottom) {
    if (bottom_ == 0) std::abort();
    if (bottom_ < 0) {
      top_ = -top_;
      bottom_ = -bottom_;
    }
    if (!is_small(top_) || !is_small(bottom_)) reduce();
  }
  // The coordinate as a fraction in lowest terms.
  explicit Rational(Fixed value) : top_(value.raw()), bottom_(Fixed::kOne) { reduce(); }

  int sign() const { return edgecase::sign(top_); }

  // The largest integer that is not above the fraction.
  std::int64_t floor() const {
    const Int128 whole = top_ / bottom_;
    return static_cast<std::int64_t>(whole * bottom_ > top_ ? whole - 1 : whole);
  }
  bool is_whole() const { return top_ % bottom_ == 0; }

  friend Rational operator-(const Rational& a) { return {-a.top_, a.bottom_, Raw{}}; }
  friend Rational operator+(const Rational& a, const Rational& b) {
    if (a.top_ == 0) return b;
    if (b.top_ == 0) return a;
    if (a.bottom_ == b.bottom_) return {sum(a.top_, b.top_), a.bottom_};
    if (a.is_small() && b.is_small())
      return {a.top_ * b.bottom_ + b.top_ * a.bottom_, a.bottom_ * b.bottom_};
    const Int128 common = divisor(a.bottom_, b.bottom_);
    const Int128 more = b.bottom_ / common;
    return {sum(product(a.top_, more), product(b.top_, a.bottom_ / common)),
            product(a.bottom_, more)};
  }
  friend Rational operator-(const Rational& a, const Rational& b) { return a + -b; }
  friend Rational operator*(const Rational& a, const Rational& b) {
    if (a.top_ == 0 || b.top_ == 0) return {};
    if (a.is_small() && b.is_small()) return {a.top_ * b.top_, a.bottom_ * b.bottom_};
    const Int128 one = divisor(a.top_, b.bottom_);
    const Int128 other = divisor(b.top_, a.bottom_);
    return {product(a.top_ / one, b.top_ / other), product(a.bottom_ / other, b.bottom_ / one)};
  }
  friend Rational operator/(const Rational& a, const Rational& b) {
    return a * Rational(b.bottom_, b.top_);
  }
  friend bool operator==(const Rational& a, const Rational& b) { return (a - b).sign() == 0; }
  friend bool operator<(const Rational& a, const Rational& b) { return (a - b).sign() < 0; }
  friend bool operator>(const Rational& a, const Rational& b) { return b < a; }
  friend bool operator<=(const Rational& a, const Rational& b) { return !(b < a); }
  friend bool operator>=(const Rational& a, const Rational& b) { return !(a < b); }

 private:
  struct Raw {};
  Rational(Int128 top, Int128 bottom, Raw) : top_(top), bottom_(bottom) {}

  static constexpr std::int64_t kSmall = std::int64_t{1} << 62;
  static bool is_small(Int128 value) { return value < kSmall && value > -kSmall; }
  bool is_small() const { return is_small(top_) && is_small(bottom_); }

  static Int128 divisor(Int128 a, Int128 b) {
    if (a < 0) a = -a;
    if (b < 0) b = -b;
    while (b != 0) {
      const Int128 rest = a % b;
      a = b;
      b = rest;
    }
    return a;
  }
  static Int128 product(Int128 a, Int128 b) {
    Int128 result = 0;
    if (__builtin_mul_overflow(a, b, &result)) std::abort();
    return result;
  }
  static Int128 sum(Int128 a, Int128 b) {
    Int128 result = 0;
    if (__builtin_add_overflow(a, b, &result)) std::abort();
    return result;
  }
  void reduce() {
    const Int128 common = divisor(top_, bottom_);
    top_ /= common;
    bottom_ /= common;
  }

  Int128 top_ = 0;
  Int128 bottom_ = 1;
};

inline Rational magnitude(const Rational& value) {
  return value.sign() < 0 ? -value : value;
}

// An exact position in the window.
struct Spot {
  Rational x;
  Rational y;
};

inline Spot spot(Point p) {
  return {Rational(p.x), Rational(p.y)};
}

inline Spot centre_of_pixel(int x, int y) {
  return {Rational(2 * x + 1, 2), Rational(2 * y + 1, 2)};
}

}  // namespace edgecase::oracle
