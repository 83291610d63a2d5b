// SPDX-License-Identifier: MIT
//
// Interpolation by ratios of areas, as the specification writes it (GL 4.6 core, 14.6.1): the
// barycentric coordinates of the sample, then attribute/w over 1/w.
#pragma once

#include "tests/oracles/projected_triangle.h"

namespace edgecase {

template <class T>
T by_area_ratios(const ProjectedTriangle<T>& v, T x, T y) {
  const T area = doubled_area(v.x[0], v.y[0], v.x[1], v.y[1], v.x[2], v.y[2]);
  const T a = doubled_area(v.x[1], v.y[1], v.x[2], v.y[2], x, y) / area;
  const T b = doubled_area(v.x[2], v.y[2], v.x[0], v.y[0], x, y) / area;
  const T c = doubled_area(v.x[0], v.y[0], v.x[1], v.y[1], x, y) / area;
  const T sum = a * v.values[0] / v.w[0] + b * v.values[1] / v.w[1] + c * v.values[2] / v.w[2];
  const T total = a / v.w[0] + b / v.w[1] + c / v.w[2];
  return sum / total;
}

}  // namespace edgecase
