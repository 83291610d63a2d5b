// SPDX-License-Identifier: MIT
//
// Interpolants of tests: short forms to write one down, and random ones.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "rules/values/interpolation.h"
#include "tests/support/points.h"

namespace edgecase {

// 113 bits.
__extension__ using Wide = __float128;

inline Wide magnitude_of(Wide value) {
  return value < 0 ? -value : value;
}

inline bool holds(Interval interval, Wide value) {
  return static_cast<Wide>(interval.low) <= value && value <= static_cast<Wide>(interval.high);
}

inline bool holds(Interval outer, Interval inner) {
  return outer.low <= inner.low && inner.high <= outer.high;
}

inline double width_of(Interval interval) {
  return interval.high - interval.low;
}

inline bool is_everything(Interval interval) {
  return std::isinf(interval.low) && std::isinf(interval.high);
}

// A vertex at a point that is a multiple of 2^-16.
inline HomogeneousPoint vertex_at(double x, double y) {
  return homogeneous(at(x, y));
}

// How far vertices may move on a grid of so many bits, pixels.
inline double reach_of(int bits) {
  return std::ldexp(1, -bits);
}

inline Point moved_by(Point p, Point distance) {
  return {p.x + distance.x, p.y + distance.y};
}

// Numbers of an endless row, the same on every machine for the same seed.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}
  // From low to high, both included.
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    const auto range = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<std::int64_t>(engine_() % range);
  }
  // At least low, less than high.
  double real(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }
  bool one_in(std::int64_t count) { return integer(1, count) == 1; }
  Fixed coordinate(std::int64_t limit) { return Fixed::from_raw(integer(-limit, limit)); }
  Point point(std::int64_t limit) {
    const Fixed x = coordinate(limit);
    return {x, coordinate(limit)};
  }
  // A float32 clip w from 2^-bits to 2^bits.
  double clip_w(double bits) {
    return static_cast<double>(static_cast<float>(std::exp2(real(-bits, bits))));
  }
  // A float32 number.
  double attribute(double limit) {
    return static_cast<double>(static_cast<float>(real(-limit, limit)));
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace edgecase
