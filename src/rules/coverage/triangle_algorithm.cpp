// SPDX-License-Identifier: MIT
#include "rules/coverage/triangle_algorithm.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "exact/binary32.h"
#include "exact/homogeneous.h"
#include "rules/coverage/edge_walk.h"
#include "rules/coverage/scan_conversion.h"

namespace edgecase {
namespace {

// The edge a -> b of a counter-clockwise triangle, starting at the centre of pixel (x, y). One step
// beyond a sample of the window stays below 2^62.
WalkedEdge<std::int64_t> walked_edge(Point a, Point b, int x, int y, const TieRule& ties) {
  const std::int64_t right = a.y.raw() - b.y.raw();
  const std::int64_t up = b.x.raw() - a.x.raw();
  return {cross(a, b, pixel_centre(x, y)), right * Fixed::kOne, up * Fixed::kOne,
          ties.positive(0, right, up)};
}

std::vector<PixelPosition> by_edge_functions(const Triangle& triangle, const PixelBounds& bounds,
                                             const TieRule& ties) {
  if (doubled_area(triangle) == 0) return {};
  const Triangle t = counter_clockwise(triangle);
  const PixelBounds some = sample_bounds(triangle, bounds);
  const auto edge = [&](std::size_t i) {
    return walked_edge(t[i], t[(i + 1) % 3], some.x_min, some.y_min, ties);
  };
  return walk_edges<std::int64_t>({edge(0), edge(1), edge(2)}, some);
}

// The function of the edge a -> b, where each operation is rounded.
Binary32 rounded_cross(Point a, Point b, Point p) {
  const auto x = [](Point of) { return Binary32::from_fixed(of.x); };
  const auto y = [](Point of) { return Binary32::from_fixed(of.y); };
  return (x(b) - x(a)) * (y(p) - y(a)) - (y(b) - y(a)) * (x(p) - x(a));
}

std::vector<PixelPosition> by_rounded_edges(const Triangle& triangle, const PixelBounds& bounds,
                                            const TieRule& ties) {
  if (doubled_area(triangle) == 0) return {};
  const Triangle t = counter_clockwise(triangle);
  const PixelBounds some = sample_bounds(triangle, bounds);
  const auto is_inside = [&](std::size_t i, Point sample) {
    const Point a = t[i], b = t[(i + 1) % 3];
    const Binary32 value = rounded_cross(a, b, sample);
    if (!value.is_zero()) return !value.is_negative();
    return ties.positive(0, a.y.raw() - b.y.raw(), b.x.raw() - a.x.raw());
  };
  std::vector<PixelPosition> pixels;
  for (int y = some.y_min; y <= some.y_max; ++y)
    for (int x = some.x_min; x <= some.x_max; ++x)
      if (const Point sample = pixel_centre(x, y);
          is_inside(0, sample) && is_inside(1, sample) && is_inside(2, sample))
        pixels.push_back({x, y});
  return pixels;
}

}  // namespace

bool has_tie_rule(TriangleAlgorithm algorithm) {
  return algorithm != TriangleAlgorithm::scan;
}

PixelBounds sample_bounds(const Triangle& t, const PixelBounds& bounds) {
  const auto [x_low, x_high] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [y_low, y_high] = std::minmax({t[0].y, t[1].y, t[2].y});
  const auto low = [](int bound, Fixed value) {
    return static_cast<int>(std::max<std::int64_t>(bound, value.floor() - 1));
  };
  const auto high = [](int bound, Fixed value) {
    return static_cast<int>(std::min<std::int64_t>(bound, value.floor() + 1));
  };
  return {low(bounds.x_min, x_low), low(bounds.y_min, y_low), high(bounds.x_max, x_high),
          high(bounds.y_max, y_high)};
}

std::vector<PixelPosition> triangle_pixels(const Triangle& triangle, const PixelBounds& bounds,
                                           TriangleAlgorithm algorithm, const TieRule& ties) {
  switch (algorithm) {
    case TriangleAlgorithm::edge_functions:
      return by_edge_functions(triangle, bounds, ties);
    case TriangleAlgorithm::scan:
      return scanned_triangle_pixels(triangle, bounds);
    case TriangleAlgorithm::float_edges:
      return by_rounded_edges(triangle, bounds, ties);
  }
  return {};
}

std::vector<PixelPosition> tied_triangle_pixels(const Triangle& triangle,
                                                const PixelBounds& bounds) {
  std::vector<PixelPosition> pixels = by_edge_functions(triangle, bounds, closed_ties());
  std::erase_if(pixels,
                [&](PixelPosition p) { return triangle_covers(triangle, p.x, p.y, open_ties()); });
  return pixels;
}

Rule triangle_algorithm_rule() {
  Rule rule;
  rule.id = RuleId::triangle_algorithm;
  rule.title =
      "The samples inside a triangle are found exactly or by a known algorithm that rounds";
  rule.spec = "14.6.1 (basic polygon rasterization)";
  rule.latitude = "any algorithm that obeys rulings 4 and 5";
  rule.standard = "edge-functions";
  rule.alternatives = alternatives_of<TriangleAlgorithm>();
  return rule;
}

}  // namespace edgecase
