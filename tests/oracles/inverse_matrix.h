// SPDX-License-Identifier: MIT
//
// Interpolation by the inverse of the matrix of homogeneous vertices (Olano and Greer, "Triangle
// Scan Conversion using 2D Homogeneous Coordinates", 1997).
//
// The matrix has the rows (x w, y w, w). An attribute that runs linearly in the object is
// a = A x w + B y w + C w at its vertices, so (A, B, C) is the inverse times the vertices' values,
// and a/w is A x + B y + C in the window; the constant attribute 1 gives 1/w.
#pragma once

#include "tests/oracles/projected_triangle.h"

namespace edgecase {

template <class T>
using Matrix3 = std::array<std::array<T, 3>, 3>;

// By cofactors over the determinant.
template <class T>
Matrix3<T> inverse(const Matrix3<T>& m) {
  Matrix3<T> result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t r = (j + 1) % 3, s = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
      result[i][j] = m[r][c] * m[s][d] - m[r][d] * m[s][c];
    }
  const T determinant = m[0][0] * result[0][0] + m[0][1] * result[1][0] + m[0][2] * result[2][0];
  for (auto& row : result)
    for (T& entry : row) entry = entry / determinant;
  return result;
}

template <class T>
T by_inverse_matrix(const ProjectedTriangle<T>& v, T x, T y) {
  Matrix3<T> rows{};
  for (std::size_t i = 0; i < 3; ++i) rows[i] = {v.x[i] * v.w[i], v.y[i] * v.w[i], v.w[i]};
  const Matrix3<T> inverted = inverse(rows);
  const std::array<T, 3> pixel{x, y, 1};
  T sum = 0, total = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    T share = 0;
    for (std::size_t i = 0; i < 3; ++i) share = share + inverted[i][j] * pixel[i];
    sum = sum + share * v.values[j];
    total = total + share;
  }
  return sum / total;
}

}  // namespace edgecase
