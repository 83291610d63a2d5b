// SPDX-License-Identifier: MIT
//
// CentreColors: what the colours of primitives, one after another, are at pixels' centres, for
// derivatives, which are differences of neighbours.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "rules/values/derivative.h"

namespace edgecase {

class CentreColors {
 public:
  // `width`: of the target, pixels.
  explicit CentreColors(int width);

  // From now on the primitive with these components. They have the same vertices and line
  // parameter, and those that have perspective the same w; they must stay where they are.
  void take(const std::array<Interpolant, 4>& components);

  using Components = std::array<Interval, 4>;
  // As interpolate_exact and derivative_exact have them. Asked row by row: the colours of the
  // latest rows are kept.
  const Components& at(PixelPosition pixel);
  Components derivatives(const QuadPixel& at, Axis axis, DerivativeMethod method);

 private:
  struct AtPixel {
    std::size_t primitive = 0;
    PixelPosition pixel;
    Components values;
  };

  const std::array<Interpolant, 4>* components_ = nullptr;
  std::array<bool, 4> are_constant_{};
  std::size_t primitive_ = 0;   // taken so far
  std::size_t columns_;         // a power of two
  std::vector<AtPixel> known_;  // by row and column, the lowest bits of each
};

}  // namespace edgecase
