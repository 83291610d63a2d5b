// SPDX-License-Identifier: MIT
//
// Interpolation by planes, as hardware sets it up: attribute/w and 1/w are each A x + B y + C in
// the window, with coefficients that are computed once for the triangle.
#pragma once

#include "tests/oracles/projected_triangle.h"

namespace edgecase {

// A number that runs linearly in the window.
template <class T>
struct Plane {
  T a{}, b{}, c{};
  T at(T x, T y) const { return a * x + b * y + c; }
};

template <class T>
class AttributePlanes {
 public:
  explicit AttributePlanes(const ProjectedTriangle<T>& v) {
    std::array<T, 3> parts{}, inverses{};
    for (std::size_t i = 0; i < 3; ++i) {
      parts[i] = v.values[i] / v.w[i];
      inverses[i] = T(1) / v.w[i];
    }
    attribute_ = through(v, parts);
    inverse_w_ = through(v, inverses);
  }
  T at(T x, T y) const { return attribute_.at(x, y) / inverse_w_.at(x, y); }
  // The derivative of the quotient.
  T slope_x(T x, T y) const { return slope(attribute_.a, inverse_w_.a, x, y); }
  T slope_y(T x, T y) const { return slope(attribute_.b, inverse_w_.b, x, y); }

 private:
  // The plane over the vertices with these heights: edges from the first vertex, and their normal.
  static Plane<T> through(const ProjectedTriangle<T>& v, const std::array<T, 3>& heights) {
    const T x1 = v.x[1] - v.x[0], y1 = v.y[1] - v.y[0], h1 = heights[1] - heights[0];
    const T x2 = v.x[2] - v.x[0], y2 = v.y[2] - v.y[0], h2 = heights[2] - heights[0];
    const T area = x1 * y2 - y1 * x2;
    Plane<T> plane;
    plane.a = (h1 * y2 - y1 * h2) / area;
    plane.b = (x1 * h2 - h1 * x2) / area;
    plane.c = heights[0] - plane.a * v.x[0] - plane.b * v.y[0];
    return plane;
  }
  T slope(T of_attribute, T of_inverse, T x, T y) const {
    const T below = inverse_w_.at(x, y);
    return (of_attribute * below - attribute_.at(x, y) * of_inverse) / (below * below);
  }

  Plane<T> attribute_, inverse_w_;
};

}  // namespace edgecase
