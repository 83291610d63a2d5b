// SPDX-License-Identifier: MIT
//
// A triangle as three oracles of interpolation take it (area_ratios.h, inverse_matrix.h,
// attribute_planes.h), in numbers of any type: 113 bits to know the value, float32 to compute it as
// a renderer may.
//
// What all three compute is N / D with
//
//   N = sum of area_i a_i / w_i    D = sum of area_i / w_i
//
// area_i twice the area that the sample forms with the edge opposite to vertex i. They differ in
// what they add up first, so rounding moves them apart, and by how much follows from the sizes of
// the terms. With R the largest coordinate and u the unit of rounding each term of each area, or of
// the coefficient of a plane or of the inverse that stands for it, is at most R^2 and has some
// units of u. So all of them are within a small number c of
//
//   c u R^2 sum((|a_i| + |N/D|) / w_i) / |D|
//
// of the value; `spread` is that without c and u.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "rules/values/interpolation.h"

namespace edgecase {

template <class T>
struct ProjectedTriangle {
  std::array<T, 3> x{}, y{};  // window, pixels
  std::array<T, 3> w{};       // clip w; 1 without perspective
  std::array<T, 3> values{};
};

// Values as the middles of their intervals.
template <class T>
ProjectedTriangle<T> projected(const Interpolant& f) {
  ProjectedTriangle<T> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const HomogeneousPoint& p = f.positions[i];
    result.x[i] = static_cast<T>(p.x) / static_cast<T>(p.w);
    result.y[i] = static_cast<T>(p.y) / static_cast<T>(p.w);
    result.w[i] = static_cast<T>(f.perspective ? f.w[i].low : 1.0);
    result.values[i] = static_cast<T>(f.values[i].low / 2 + f.values[i].high / 2);
  }
  return result;
}

// Twice the area of (x1, y1), (x2, y2), (x, y), positive when they turn left.
template <class T>
T doubled_area(T x1, T y1, T x2, T y2, T x, T y) {
  return (x1 - x) * (y2 - y) - (y1 - y) * (x2 - x);
}

struct Spread {
  double of_formulas = 0;  // R^2 sum((|a_i| + |N/D|) / w_i) / |D|, as above
  double of_sum = 0;       // sum(|area_i| (|a_i| + |N/D|) / w_i) / |D|: areas known exactly
};

template <class T>
Spread spread_of(const ProjectedTriangle<T>& v, T x, T y) {
  const auto size = [](T value) { return std::fabs(static_cast<double>(value)); };
  double reach = std::max({1.0, size(x), size(y)});
  std::array<T, 3> areas{};
  T sum = 0, total = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    areas[i] = doubled_area(v.x[j], v.y[j], v.x[k], v.y[k], x, y);
    sum += areas[i] * v.values[i] / v.w[i];
    total += areas[i] / v.w[i];
    reach = std::max({reach, size(v.x[i]), size(v.y[i])});
  }
  Spread result;
  for (std::size_t i = 0; i < 3; ++i) {
    const double part = (size(v.values[i]) + size(sum / total)) / size(v.w[i]) / size(total);
    result.of_formulas += reach * reach * part;
    result.of_sum += size(areas[i]) * part;
  }
  return result;
}

}  // namespace edgecase
