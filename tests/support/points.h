// SPDX-License-Identifier: MIT
//
// Short forms for points of tests, and for pixels.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "exact/fixed.h"

namespace edgecase {

// A point from doubles that are multiples of 2^-16.
inline Point at(double x, double y) {
  return {Fixed::from_raw(static_cast<std::int64_t>(x * Fixed::kOne)),
          Fixed::from_raw(static_cast<std::int64_t>(y * Fixed::kOne))};
}

// A point from multiples of 2^-16.
inline Point raw(std::int64_t x, std::int64_t y) {
  return {Fixed::from_raw(x), Fixed::from_raw(y)};
}

inline std::vector<PixelPosition> sorted(std::vector<PixelPosition> pixels) {
  std::sort(pixels.begin(), pixels.end());
  return pixels;
}

}  // namespace edgecase
