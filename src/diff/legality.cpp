// SPDX-License-Identifier: MIT
#include "diff/legality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rules/choices.h"
#include "rules/coverage/line_latitude.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/shared_edge.h"
#include "rules/coverage/snap.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {
namespace {

Triangle triangle_of(const ScenePrimitive& primitive) {
  return {primitive.vertices[0].position, primitive.vertices[1].position,
          primitive.vertices[2].position};
}

Segment segment_of(const ScenePrimitive& primitive, Snap snap) {
  return {snap(primitive.vertices[0].position), snap(primitive.vertices[1].position)};
}

PixelBounds bounds_of(const Target& target) {
  return {0, 0, target.width - 1, target.height - 1};
}

bool possibly_covered(const ScenePrimitive& primitive, PixelPosition p, int bits) {
  if (primitive.state->primitive == Primitive::points)
    return point_possibly_covered(primitive.vertices[0].position, p.x, p.y, bits);
  return triangle_possibly_covered(triangle_of(primitive), pixel_centre(p.x, p.y), bits);
}

bool possibly_uncovered(const ScenePrimitive& primitive, PixelPosition p, int bits) {
  if (primitive.state->primitive == Primitive::points)
    return point_possibly_uncovered(primitive.vertices[0].position, p.x, p.y, bits);
  return triangle_possibly_uncovered(triangle_of(primitive), pixel_centre(p.x, p.y), bits);
}

long count(std::span<const PixelPosition> pixels, PixelPosition p) {
  return std::count(pixels.begin(), pixels.end(), p);
}

// Pixels whose centres may lie near the segment a-b: its bounding box, grown by one.
PixelBounds bounds_near(Point a, Point b, const PixelBounds& target) {
  const auto [x_low, x_high] = std::minmax(a.x, b.x);
  const auto [y_low, y_high] = std::minmax(a.y, b.y);
  const auto clip = [](std::int64_t value, int low, int high) {
    return static_cast<int>(std::clamp<std::int64_t>(value, low, high));
  };
  return {clip(x_low.floor() - 1, target.x_min, target.x_max + 1),
          clip(y_low.floor() - 1, target.y_min, target.y_max + 1),
          clip(x_high.floor() + 1, target.x_min - 1, target.x_max),
          clip(y_high.floor() + 1, target.y_min - 1, target.y_max)};
}

}  // namespace

int latitude_bits(int reported_subpixel_bits) {
  return std::clamp(reported_subpixel_bits, 4, Fixed::kFractionBits);
}

Legality judge_sample(const ScenePrimitive& primitive, const CoverageDifference& difference,
                      int bits) {
  const bool point = primitive.state->primitive == Primitive::points;
  const bool extra = difference.drawn > difference.exact;
  Legality result;
  result.rule = coverage_rule_of(primitive.state->primitive);
  result.ruling = point ? 6 : 4;
  result.legal = extra ? possibly_covered(primitive, difference.pixel, bits)
                       : possibly_uncovered(primitive, difference.pixel, bits);
  result.reason = fmt::format("{} move of the {} by less than 1/{} pixel {} the sample {}",
                              result.legal ? "some" : "no", point ? "vertex" : "vertices",
                              1 << bits, result.legal ? "puts" : "could put",
                              extra ? "inside or on the boundary" : "outside or on the boundary");
  return result;
}

std::vector<std::string> legal_line_snaps(const ScenePrimitive& line,
                                          std::span<const PixelPosition> drawn,
                                          const Target& target) {
  std::vector<std::string> result;
  for (Snap snap : all_snaps())
    if (broken_line_clause(segment_of(line, snap), drawn, bounds_of(target)).empty())
      result.push_back(name_of(snap));
  return result;
}

std::string broken_clause_unsnapped(const ScenePrimitive& line,
                                    std::span<const PixelPosition> drawn, const Target& target) {
  return broken_line_clause(segment_of(line, Snap{}), drawn, bounds_of(target));
}

std::vector<SharedEdgeFault> shared_edge_faults(std::span<const ScenePrimitive> primitives,
                                                std::span<const PrimitiveCoverage> coverage,
                                                const Target& target, int bits) {
  std::vector<SharedEdgeFault> faults;
  const auto is_triangle = [](const ScenePrimitive& p) {
    return p.state->primitive == Primitive::triangles;
  };
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    for (std::size_t j = i + 1; j < primitives.size(); ++j) {
      if (!is_triangle(primitives[i]) || !is_triangle(primitives[j])) continue;
      const auto edge = shared_edge(triangle_of(primitives[i]), triangle_of(primitives[j]));
      if (!edge) continue;
      const PixelBounds near = bounds_near(edge->a, edge->b, bounds_of(target));
      for (int y = near.y_min; y <= near.y_max; ++y) {
        for (int x = near.x_min; x <= near.x_max; ++x) {
          const long hits = count(coverage[i].drawn, {x, y}) + count(coverage[j].drawn, {x, y});
          if (hits == 1 || !must_hit_once(*edge, pixel_centre(x, y), bits)) continue;
          faults.push_back(
              {{x, y}, primitives[i].index, primitives[j].index, static_cast<int>(hits)});
        }
      }
    }
  }
  return faults;
}

}  // namespace edgecase
