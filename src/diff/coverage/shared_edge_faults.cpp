// SPDX-License-Identifier: MIT
#include "diff/coverage/shared_edge_faults.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>

#include "diff/coverage/clipped_seams.h"
#include "diff/coverage/facing_latitude.h"
#include "diff/coverage/seam_hits.h"
#include "diff/coverage/vertex_latitude.h"
#include "raster/rasterizer.h"
#include "rules/coverage/homogeneous_triangle.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {
namespace {

// Quotients are rounded to the nearest point; reach_of accounts for the error.
Triangle triangle_of(const ScenePrimitive& primitive) {
  return nearest_triangle(primitive.positions);
}

// The common edge of two triangles, whose ends must be bit-identical and not only close.
std::optional<SharedEdge> common_edge(const ScenePrimitive& first, const ScenePrimitive& second) {
  const Triangle one = triangle_of(first);
  const Triangle other = triangle_of(second);
  const auto edge = shared_edge(one, other);
  if (!edge) return std::nullopt;
  const auto vertex_at = [](const ScenePrimitive& primitive, const Triangle& triangle, Point p) {
    return primitive.vertices[static_cast<std::size_t>(
        std::find(triangle.begin(), triangle.end(), p) - triangle.begin())];
  };
  for (const Point end : {edge->a, edge->b})
    if (!is_bit_identical(*vertex_at(first, one, end), *vertex_at(second, other, end)))
      return std::nullopt;
  return edge;
}

// The common edge of two triangles, how far vertices may move, and the pixels near it.
struct SharedSide {
  SharedEdge edge;
  Fixed reach;
  PixelBounds near;
  bool is_multisampled = false;

  bool must_hit_once(Point sample) const { return edgecase::must_hit_once(edge, sample, reach); }
  bool is_clear(Point sample, Fixed more) const { return lies_between(edge, sample, reach + more); }
};

// Triangles by their edges, counter-clockwise.
using TrianglesByEdge = std::map<std::array<std::int64_t, 4>, std::vector<std::size_t>>;

std::array<std::int64_t, 4> key_of(Point from, Point to) {
  return {from.x.raw(), from.y.raw(), to.x.raw(), to.y.raw()};
}

// Facts about one primitive that do not depend on its partner.
struct Facts {
  bool may_be_culled = false;
  bool is_multisampled = false;
  Fixed reach;
  PixelBounds drawable;
};

Facts facts_of(const ScenePrimitive& primitive, const Scene& scene, int bits) {
  return {permitted_culling(primitive, bits).may_be_culled,
          is_multisampled(*primitive.state, scene.target), reach_of(primitive, bits),
          drawable_bounds(*primitive.state, scene.target)};
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> neighbours(
    std::span<const ScenePrimitive> primitives) {
  TrianglesByEdge before;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    // Clipped ones have seams of their own (diff/coverage/clipped_seams.h).
    if (primitives[i].kind != PrimitiveKind::triangle || primitives[i].is_clipped) continue;
    const Triangle given = triangle_of(primitives[i]);
    if (doubled_area(given) == 0) continue;
    const Triangle t = counter_clockwise(given);
    // Triangles on opposite sides of an edge run along it in opposite directions. Each is looked up
    // by one edge only, since both wind alike.
    for (std::size_t k = 0; k < 3; ++k) {
      const auto others = before.find(key_of(t[(k + 1) % 3], t[k]));
      if (others == before.end()) continue;
      for (const std::size_t other : others->second) pairs.emplace_back(other, i);
    }
    for (std::size_t k = 0; k < 3; ++k) before[key_of(t[k], t[(k + 1) % 3])].push_back(i);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<SharedEdgeFault> shared_edge_faults(std::span<const ScenePrimitive> primitives,
                                                std::span<const PrimitiveCoverage> coverage,
                                                const Scene& scene, int bits,
                                                const SamplePositions& positions,
                                                bool exact_has_none) {
  std::vector<SharedEdgeFault> faults;
  std::vector<std::optional<Facts>> known(primitives.size());
  const auto facts = [&](std::size_t i) -> const Facts& {
    if (!known[i]) known[i] = facts_of(primitives[i], scene, bits);
    return *known[i];
  };
  const auto is_as_exact = [&](std::size_t i) {
    const PrimitiveCoverage& own = coverage[static_cast<std::size_t>(primitives[i].index)];
    return own.drawn == own.exact;
  };
  for (const auto& [i, j] : neighbours(primitives)) {
    if (exact_has_none && is_as_exact(i) && is_as_exact(j)) continue;
    const Facts& one = facts(i);
    const Facts& other = facts(j);
    // Ruling 40 permits fragments of triangles that may be culled to be missing.
    if (one.may_be_culled || other.may_be_culled) continue;
    if (one.is_multisampled != other.is_multisampled) continue;
    const auto edge = common_edge(primitives[i], primitives[j]);
    if (!edge) continue;
    const SharedSide side{*edge, std::max(one.reach, other.reach),
                          bounds_near(edge->a, edge->b, common_part(one.drawable, other.drawable)),
                          one.is_multisampled};
    for (const auto& [sample, within] :
         shared_samples(primitives[i], primitives[j], scene.target, positions))
      add_seam_faults(side, primitives[i].index, primitives[j].index, sample, within, coverage,
                      faults);
  }
  const auto clipped =
      clipped_seam_faults(primitives, coverage, scene, bits, positions, exact_has_none);
  faults.insert(faults.end(), clipped.begin(), clipped.end());
  return faults;
}

}  // namespace edgecase
