// SPDX-License-Identifier: MIT
#include "rules/coverage/homogeneous_triangle.h"

namespace edgecase {
namespace {

// A sample's coordinates are at most 2^15 and its w is 2, so that an edge function, by the bounds
// of exact/homogeneous.h, is below 2^96: within what TieRule takes.
bool inside_edge(const HomogeneousPoint& a, const HomogeneousPoint& b,
                 const HomogeneousPoint& sample, const TieRule& ties) {
  const Int128 right = Int128{a.y} * b.w - Int128{b.y} * a.w;
  const Int128 up = Int128{b.x} * a.w - Int128{a.x} * b.w;
  return ties.positive(cross(a, b, sample), right, up);
}

}  // namespace

Triangle nearest_triangle(const HomogeneousTriangle& t) {
  return {nearest_point(t[0]), nearest_point(t[1]), nearest_point(t[2])};
}

bool triangle_covers(const HomogeneousTriangle& triangle, int x, int y, const TieRule& ties) {
  const auto& [a, b, c] = triangle;
  const Int128 area = cross(a, b, c);
  if (area == 0) return false;
  const HomogeneousPoint sample = homogeneous_centre(x, y);
  const auto inside = [&](const HomogeneousPoint& from, const HomogeneousPoint& to) {
    return area > 0 ? inside_edge(from, to, sample, ties) : inside_edge(to, from, sample, ties);
  };
  return inside(a, b) && inside(b, c) && inside(c, a);
}

std::vector<PixelPosition> triangle_pixels(const HomogeneousTriangle& triangle,
                                           const PixelBounds& bounds, TriangleAlgorithm algorithm,
                                           const TieRule& ties) {
  const Triangle nearest = nearest_triangle(triangle);
  if (algorithm != TriangleAlgorithm::edge_functions)
    return triangle_pixels(nearest, bounds, algorithm, ties);
  // The nearest triangle's box reaches a pixel beyond it, so it holds the samples of this one.
  const PixelBounds some = sample_bounds(nearest, bounds);
  std::vector<PixelPosition> pixels;
  for (int y = some.y_min; y <= some.y_max; ++y)
    for (int x = some.x_min; x <= some.x_max; ++x)
      if (triangle_covers(triangle, x, y, ties)) pixels.push_back({x, y});
  return pixels;
}

}  // namespace edgecase
