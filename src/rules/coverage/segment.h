// SPDX-License-Identifier: MIT
//
// A line segment from a to b, and which of its axes is the major one.
#pragma once

#include <cstdlib>

#include "exact/fixed.h"

namespace edgecase {

struct Segment {
  Point a;
  Point b;

  // Slope in [-1, 1]: 45 degrees counts as x-major, and so does a segment without length.
  bool x_major() const {
    return std::abs(b.x.raw() - a.x.raw()) >= std::abs(b.y.raw() - a.y.raw());
  }
};

}  // namespace edgecase
