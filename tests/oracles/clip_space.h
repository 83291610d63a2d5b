// SPDX-License-Identifier: MIT
//
// What a triangle in clip space shows at a point of the window, by solving for the point of the
// triangle that projects there: three linear equations in fractions, nothing else.
#pragma once

#include <array>
#include <optional>

#include "exact/rational.h"
#include "model/scene.h"

namespace edgecase::oracle {

using RationalTriple = std::array<Rational, 3>;

inline Rational determinant(const RationalTriple& a, const RationalTriple& b,
                            const RationalTriple& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) +
         c[0] * (a[1] * b[2] - a[2] * b[1]);
}

// b with sum of b_i (x_i, y_i, w_i) = (x, y, 1) in normalized device coordinates, so that the
// point lies in the triangle where all b_i are at least 0, and 1/w is their sum. None where the
// triangle is seen edge on.
inline std::optional<RationalTriple> shares_at(const std::array<ClipPosition, 3>& triangle,
                                               const Rational& x, const Rational& y) {
  std::array<RationalTriple, 3> columns;
  for (std::size_t i = 0; i < 3; ++i)
    columns[i] = {rational_of(triangle[i].x), rational_of(triangle[i].y),
                  rational_of(triangle[i].w)};
  const Rational area = determinant(columns[0], columns[1], columns[2]);
  if (area == 0) return std::nullopt;
  const RationalTriple point{x, y, 1};
  return RationalTriple{determinant(point, columns[1], columns[2]) / area,
                        determinant(columns[0], point, columns[2]) / area,
                        determinant(columns[0], columns[1], point) / area};
}

// From pixels of a viewport to normalized device coordinates, along one axis.
inline Rational normalized(const Rational& at, int low, int size) {
  return (at - low) * 2 / size - 1;
}

}  // namespace edgecase::oracle
