// SPDX-License-Identifier: MIT
//
// The next double above and below a double, as std::nextafter with an infinity, in line: outward
// rounding takes one for each end of each operation, and a call into the C library for each made
// half of the time that judging values took.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace edgecase {

// The smallest double above; infinity stays infinity. The value must not be NaN.
inline double next_above(double value) {
  if (value == std::numeric_limits<double>::infinity()) return value;
  // Doubles of one sign are in the order of their bits; adding zero turns -0 into +0.
  const auto bits = std::bit_cast<std::int64_t>(value + 0.0);
  return std::bit_cast<double>(bits < 0 ? bits - 1 : bits + 1);
}

// The largest double below; minus infinity stays minus infinity. The value must not be NaN.
inline double next_below(double value) {
  return -next_above(-value);
}

}  // namespace edgecase
