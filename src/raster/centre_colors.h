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
  struct Derivatives {
    Components exact;
    std::array<double, 4> middles{};  // see raster/attributes.h
  };
  // As interpolate_exact and derivative_exact have them. What is linear has the same derivatives at
  // all pixels. Of the rest, asked row by row: of the latest rows, colours and their differences,
  // which the pixels of a quad share, are kept. Valid until the next question.
  const Components& at(PixelPosition pixel);
  const Derivatives& derivatives(const QuadPixel& at, Axis axis, DerivativeMethod method);

 private:
  struct AtPixel {
    std::size_t primitive = 0;
    PixelPosition pixel;
    Components values;
  };
  struct AtNeighbours {
    std::size_t primitive = 0;
    Neighbours pixels;
    Derivatives derivatives;
  };

  std::size_t place_of(PixelPosition pixel) const;
  Components difference(const Neighbours& of, Axis axis);

  const std::array<Interpolant, 4>* components_ = nullptr;
  std::array<bool, 4> are_linear_{};
  std::array<Derivatives, 2> slopes_;  // of those, by axis
  std::size_t primitive_ = 0;          // taken so far
  std::size_t columns_;                // a power of two
  // By row and column, the lowest bits of each; differences by axis and by their first pixel.
  std::vector<AtPixel> known_;
  std::array<std::vector<AtNeighbours>, 2> differences_;
  Derivatives analytic_;  // the latest
};

}  // namespace edgecase
