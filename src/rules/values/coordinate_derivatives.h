// SPDX-License-Identifier: MIT
//
// What rules/values/derivative.h says of both texture coordinates of a primitive. What they share
// is worked out once.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "rules/values/derivative.h"

namespace edgecase {

// Of s and t, which have the same vertices and line parameter and, with perspective, the same w.
std::array<Interval, 2> derivatives_exact(const Interpolant& s, const Interpolant& t,
                                          const QuadPixel& at, Axis axis, DerivativeMethod method);

// The same with inexact operations, of many pixels, rows one after another. The differences of
// neighbours are made of the same values, so those of the latest rows are kept.
class InexactDerivatives {
 public:
  // `width`: of the target, pixels.
  explicit InexactDerivatives(int width);

  // `primitive`: the number by which s and t are known.
  std::array<Interval, 2> at(int primitive, const Interpolant& s, const Interpolant& t,
                             const QuadPixel& at, Axis axis, DerivativeMethod method);

 private:
  struct AtPixel {
    int primitive = -1;
    PixelPosition pixel;
    std::array<Interval, 2> values;  // of s and t
  };
  const AtPixel& at_pixel(int primitive, const Interpolant& s, const Interpolant& t,
                          PixelPosition pixel);

  std::size_t columns_;         // a power of two
  std::vector<AtPixel> known_;  // by row and column, the lowest bits of each
};

}  // namespace edgecase
