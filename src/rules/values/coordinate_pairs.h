// SPDX-License-Identifier: MIT
//
// The values and derivatives of both texture coordinates at the pixels of a drawing, row after row.
// The part that the coordinates share is computed once, and differences of neighbours share values,
// so those of the latest rows are cached.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "model/rendering.h"
#include "rules/values/derivative.h"
#include "rules/values/exact_interpolation.h"
#include "rules/values/inexact_interpolation.h"

namespace edgecase {

// `Place`: ExactPlace or InexactPlace.
template <class Place>
class CoordinatePairs {
 public:
  // `width`: that of the target, pixels.
  explicit CoordinatePairs(int width);

  // s and t at a pixel's centre. They have the same vertices and line parameter and, with
  // perspective, the same w. `primitive`: the number that identifies them, from 0.
  std::array<Interval, 2> at(int primitive, const Interpolant& s, const Interpolant& t,
                             PixelPosition pixel);

  // Their derivatives: derivative_exact or derivative_inexact of each.
  std::array<Interval, 2> derivatives(int primitive, const Interpolant& s, const Interpolant& t,
                                      const QuadPixel& at, Axis axis, DerivativeMethod method);

 private:
  struct AtPixel {
    int primitive = -1;
    PixelPosition pixel;
    std::array<Interval, 2> values;  // of s and t
  };

  Place place_at(int primitive, const Interpolant& s, Point sample);

  std::size_t columns_;         // a power of two
  std::vector<AtPixel> known_;  // by row and column, the lowest bits of each
  int vertices_of_ = -1;        // the primitive of `vertices_`
  std::optional<UnmovedVertices> vertices_;
};

using ExactCoordinates = CoordinatePairs<ExactPlace>;
using InexactCoordinates = CoordinatePairs<InexactPlace>;

}  // namespace edgecase
