// SPDX-License-Identifier: MIT
//
// Short forms for points of tests.
#pragma once

#include "exact/fixed.h"

namespace edgecase {

// A point from doubles that are multiples of 2^-16.
inline Point at(double x, double y) {
  return {Fixed::from_raw(static_cast<std::int64_t>(x * Fixed::kOne)),
          Fixed::from_raw(static_cast<std::int64_t>(y * Fixed::kOne))};
}

}  // namespace edgecase
