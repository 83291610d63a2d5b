// SPDX-License-Identifier: MIT
#include "rules/coverage/homogeneous_triangle.h"

#include <cassert>
#include <cstdint>
#include <cstdlib>

#include "rules/coverage/edge_walk.h"

namespace edgecase {
namespace {

// A sample's coordinates are at most 2^30 and its w 2^16, so an edge function is below 2^111 by the
// bounds of exact/homogeneous.h: within the range of TieRule.
bool inside_edge(const HomogeneousPoint& a, const HomogeneousPoint& b,
                 const HomogeneousPoint& sample, const TieRule& ties) {
  [[maybe_unused]] constexpr std::int64_t kMost = std::int64_t{1} << 30;
  assert(std::abs(sample.x) <= kMost && std::abs(sample.y) <= kMost);
  assert(0 < sample.w && sample.w <= Fixed::kOne);
  const Int128 right = Int128{a.y} * b.w - Int128{b.y} * a.w;
  const Int128 up = Int128{b.x} * a.w - Int128{a.x} * b.w;
  return ties.positive(cross(a, b, sample), right, up);
}

// The same function, starting at a sample. The next pixel's sample has its coordinate larger by w.
WalkedEdge<Int128> walked_edge(const HomogeneousPoint& a, const HomogeneousPoint& b,
                               const HomogeneousPoint& sample, const TieRule& ties) {
  const Int128 right = Int128{a.y} * b.w - Int128{b.y} * a.w;
  const Int128 up = Int128{b.x} * a.w - Int128{a.x} * b.w;
  return {cross(a, b, sample), right * sample.w, up * sample.w, ties.positive(0, right, up)};
}

// The triangle moved so that the samples of pixels become their centres.
Triangle centred(const Triangle& triangle, Point within) {
  const Point centre = centre_of_pixel();
  const auto moved = [&](Point p) {
    return Point{p.x + centre.x - within.x, p.y + centre.y - within.y};
  };
  return {moved(triangle[0]), moved(triangle[1]), moved(triangle[2])};
}

}  // namespace

Triangle nearest_triangle(const HomogeneousTriangle& t) {
  return {nearest_point(t[0]), nearest_point(t[1]), nearest_point(t[2])};
}

bool triangle_covers(const HomogeneousTriangle& triangle, const HomogeneousPoint& sample,
                     const TieRule& ties) {
  const auto& [a, b, c] = triangle;
  const Int128 area = cross(a, b, c);
  if (area == 0) return false;
  const auto inside = [&](const HomogeneousPoint& from, const HomogeneousPoint& to) {
    return area > 0 ? inside_edge(from, to, sample, ties) : inside_edge(to, from, sample, ties);
  };
  return inside(a, b) && inside(b, c) && inside(c, a);
}

std::vector<PixelPosition> triangle_pixels(const HomogeneousTriangle& triangle,
                                           const PixelBounds& bounds, TriangleAlgorithm algorithm,
                                           const TieRule& ties, Point within) {
  const Triangle nearest = nearest_triangle(triangle);
  if (algorithm != TriangleAlgorithm::edge_functions)
    return triangle_pixels(centred(nearest, within), bounds, algorithm, ties);
  // The nearest triangle's box reaches a pixel beyond it, so it contains the samples of this one.
  const PixelBounds some = sample_bounds(nearest, bounds);
  const auto& [a, b, c] = triangle;
  const Int128 area = cross(a, b, c);
  if (area == 0) return {};
  const bool at_centre = within == centre_of_pixel();
  const PixelPosition first{some.x_min, some.y_min};
  const HomogeneousPoint sample =
      at_centre ? homogeneous_centre(first.x, first.y) : homogeneous(place_in(first, within));
  const auto edge = [&](const HomogeneousPoint& from, const HomogeneousPoint& to) {
    return area > 0 ? walked_edge(from, to, sample, ties) : walked_edge(to, from, sample, ties);
  };
  return walk_edges<Int128>({edge(a, b), edge(b, c), edge(c, a)}, some);
}

}  // namespace edgecase
