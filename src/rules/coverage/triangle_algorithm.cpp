// SPDX-License-Identifier: MIT
#include "rules/coverage/triangle_algorithm.h"

#include <algorithm>
#include <array>

#include "rules/coverage/triangle_scan.h"

namespace edgecase {
namespace {

constexpr std::array kAlgorithms = {TriangleAlgorithm::edge_functions, TriangleAlgorithm::scan};

std::vector<PixelPosition> by_edge_functions(const Triangle& triangle, const PixelBounds& bounds,
                                             const TieRule& ties) {
  const PixelBounds some = sample_bounds(triangle, bounds);
  std::vector<PixelPosition> pixels;
  for (int y = some.y_min; y <= some.y_max; ++y)
    for (int x = some.x_min; x <= some.x_max; ++x)
      if (triangle_covers(triangle, x, y, ties)) pixels.push_back({x, y});
  return pixels;
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

Rule triangle_algorithm_rule() {
  Rule rule;
  rule.id = "triangle.algorithm";
  rule.title = "The samples inside a triangle are found exactly, or by a known way of rounding";
  rule.spec = "14.6.1 (basic polygon rasterization)";
  rule.latitude = "any algorithm that holds rulings 4 and 5";
  rule.standard = "edge-functions";
  rule.alternatives = {
      {"edge-functions", Openness::open, "exact; samples on an edge follow triangle.fill-rule"},
      {"scan", Openness::open,
       "scan conversion in single precision, row by row upward: edges with rounded slopes, of "
       "samples on an edge those on right and top edges are drawn; vertices that are quotients by "
       "w "
       "and are not snapped are first taken to the nearest multiple of 2^-16"}};
  return rule;
}

}  // namespace edgecase
