// SPDX-License-Identifier: MIT
#include "rules/coverage/triangle_algorithm.h"

#include <algorithm>
#include <array>

#include "rules/coverage/edge_walk.h"
#include "rules/coverage/triangle_scan.h"

namespace edgecase {
namespace {

constexpr std::array kAlgorithms = {TriangleAlgorithm::edge_functions, TriangleAlgorithm::scan};

// The edge a -> b of a counter-clockwise triangle, from the centre of pixel (x, y) on. One step
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

}  // namespace

std::span<const TriangleAlgorithm> all_triangle_algorithms() {
  return kAlgorithms;
}

const char* name_of(TriangleAlgorithm algorithm) {
  switch (algorithm) {
    case TriangleAlgorithm::edge_functions:
      return "edge-functions";
    case TriangleAlgorithm::scan:
      return "scan";
  }
  return "?";
}

bool parse_name(std::string_view name, TriangleAlgorithm& algorithm) {
  for (TriangleAlgorithm candidate : kAlgorithms) {
    if (name != name_of(candidate)) continue;
    algorithm = candidate;
    return true;
  }
  return false;
}

bool has_tie_rule(TriangleAlgorithm algorithm) {
  return algorithm == TriangleAlgorithm::edge_functions;
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
  }
  return {};
}

std::vector<PixelPosition> tied_triangle_pixels(const Triangle& triangle,
                                                const PixelBounds& bounds) {
  static const TieRule& open = *find_tie_rule("open");
  static const TieRule& closed = *find_tie_rule("closed");
  std::vector<PixelPosition> pixels = by_edge_functions(triangle, bounds, closed);
  std::erase_if(pixels, [&](PixelPosition p) { return triangle_covers(triangle, p.x, p.y, open); });
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
  rule.alternatives = {
      {"edge-functions", Openness::open, "exact; samples on an edge follow triangle.fill-rule"},
      {"scan", Openness::open,
       "scan conversion in single precision, row by row upward, with rounded slopes; right and "
       "bottom edges own the samples on them; vertices that are divided by w and not snapped are "
       "first rounded to the nearest multiple of 2^-16"}};
  return rule;
}

}  // namespace edgecase
