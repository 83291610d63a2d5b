// SPDX-License-Identifier: MIT
#include "diff/legality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "raster/rasterizer.h"
#include "rules/choices.h"
#include "rules/coverage/line_algorithm.h"
#include "rules/coverage/line_latitude.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/shared_edge.h"
#include "rules/coverage/snap.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {
namespace {

Triangle triangle_of(const ScenePrimitive& primitive) {
  return {primitive.vertices[0]->position, primitive.vertices[1]->position,
          primitive.vertices[2]->position};
}

SeenLine seen_line(const ScenePrimitive& line, Snap snap, const Target& target) {
  return {{snap(line.vertices[0]->position), snap(line.vertices[1]->position)},
          rounded_width(line.state->line_width),
          drawable_bounds(*line.state, target)};
}

SizedPoint point_of(const ScenePrimitive& primitive) {
  return {primitive.vertices[0]->position, primitive.state->point_size};
}

bool possibly_covered(const ScenePrimitive& primitive, PixelPosition p, int bits) {
  if (primitive.kind == PrimitiveKind::point)
    return point_possibly_covered(point_of(primitive), p.x, p.y, bits);
  return triangle_possibly_covered(triangle_of(primitive), pixel_centre(p.x, p.y), bits);
}

bool possibly_uncovered(const ScenePrimitive& primitive, PixelPosition p, int bits) {
  if (primitive.kind == PrimitiveKind::point)
    return point_possibly_uncovered(point_of(primitive), p.x, p.y, bits);
  return triangle_possibly_uncovered(triangle_of(primitive), pixel_centre(p.x, p.y), bits);
}

// How often a pixel is among pixels that are sorted row first.
long count(std::span<const PixelPosition> pixels, PixelPosition p) {
  const auto [first, last] =
      std::equal_range(pixels.begin(), pixels.end(), p, [](PixelPosition a, PixelPosition b) {
        return std::tie(a.y, a.x) < std::tie(b.y, b.x);
      });
  return last - first;
}

PixelBounds common(const PixelBounds& a, const PixelBounds& b) {
  return {std::max(a.x_min, b.x_min), std::max(a.y_min, b.y_min), std::min(a.x_max, b.x_max),
          std::min(a.y_max, b.y_max)};
}

// Pixels whose centres may lie near the segment a-b: its bounding box, grown by one.
PixelBounds bounds_near(Point a, Point b, const PixelBounds& target) {
  const auto [x_low, x_high] = std::minmax(a.x, b.x);
  const auto [y_low, y_high] = std::minmax(a.y, b.y);
  const auto clip = [](std::int64_t value) {
    return static_cast<int>(
        std::clamp<std::int64_t>(value, -2 * Fixed::kMaxCoordinate, 2 * Fixed::kMaxCoordinate));
  };
  return common(target, {clip(x_low.floor() - 1), clip(y_low.floor() - 1), clip(x_high.floor() + 1),
                         clip(y_high.floor() + 1)});
}

}  // namespace

int latitude_bits(int reported_subpixel_bits) {
  return std::clamp(reported_subpixel_bits, 4, Fixed::kFractionBits);
}

Legality judge_sample(const ScenePrimitive& primitive, const CoverageDifference& difference,
                      int bits) {
  const bool point = primitive.kind == PrimitiveKind::point;
  const bool extra = difference.drawn > difference.exact;
  Legality result;
  result.rule = coverage_rule_of(primitive.kind);
  result.ruling = point ? 6 : 4;
  result.legal = extra ? possibly_covered(primitive, difference.pixel, bits)
                       : possibly_uncovered(primitive, difference.pixel, bits);
  result.reason = fmt::format("{} move of the {} by less than 1/{} pixel {} the sample {}",
                              result.legal ? "some" : "no", point ? "vertex" : "vertices",
                              1 << bits, result.legal ? "puts" : "could put",
                              extra ? "inside or on the boundary" : "outside or on the boundary");
  return result;
}

std::vector<std::string> illegal_line_snaps(const ScenePrimitive& line,
                                            std::span<const PixelPosition> drawn,
                                            const Target& target) {
  std::vector<std::string> result;
  for (Snap snap : all_snaps())
    if (!broken_line_clause(seen_line(line, snap, target), drawn).empty())
      result.push_back(name_of(snap));
  return result;
}

std::string broken_clause_unsnapped(const ScenePrimitive& line,
                                    std::span<const PixelPosition> drawn, const Target& target) {
  return broken_line_clause(seen_line(line, Snap{}, target), drawn);
}

int ruling_on_line(const ScenePrimitive& line, const Target& target) {
  const SeenLine seen = seen_line(line, Snap{}, target);
  if (seen.width != 1) return 12;
  return is_unseen(seen) ? 2 : 1;
}

bool is_about_a_line(const Disagreement& disagreement) {
  return disagreement.rule == "line.diamond-exit" || disagreement.rule == "line.joint";
}

std::vector<SharedEdgeFault> shared_edge_faults(std::span<const ScenePrimitive> primitives,
                                                std::span<const PrimitiveCoverage> coverage,
                                                const Target& target, int bits) {
  std::vector<SharedEdgeFault> faults;
  const auto is_triangle = [](const ScenePrimitive& p) {
    return p.kind == PrimitiveKind::triangle;
  };
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    for (std::size_t j = i + 1; j < primitives.size(); ++j) {
      if (!is_triangle(primitives[i]) || !is_triangle(primitives[j])) continue;
      const auto edge = shared_edge(triangle_of(primitives[i]), triangle_of(primitives[j]));
      if (!edge) continue;
      const PixelBounds near = bounds_near(edge->a, edge->b,
                                           common(drawable_bounds(*primitives[i].state, target),
                                                  drawable_bounds(*primitives[j].state, target)));
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
