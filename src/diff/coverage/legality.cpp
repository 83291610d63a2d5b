// SPDX-License-Identifier: MIT
#include "diff/coverage/legality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "diff/coverage/facing_latitude.h"
#include "diff/values/vertex_latitude.h"
#include "raster/rasterizer.h"
#include "rules/choices.h"
#include "rules/coverage/homogeneous_triangle.h"
#include "rules/coverage/line_algorithm.h"
#include "rules/coverage/line_latitude.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/shared_edge.h"
#include "rules/coverage/snap.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/samples/multisampled_line.h"

namespace edgecase {
namespace {

// Of quotients, the nearest: reach_of knows how far off they are.
Triangle triangle_of(const ScenePrimitive& primitive) {
  return nearest_triangle(primitive.positions);
}

SizedPoint point_of(const ScenePrimitive& primitive) {
  return {nearest_point(primitive.positions[0]), primitive.state->point_size};
}

SeenLine seen_line(const ScenePrimitive& line, Snap snap, const Scene& scene) {
  const auto [segment, reach] = snapped_segment(line, snap, scene.viewport);
  return {segment, rounded_width(line.state->line_width),
          drawable_bounds(*line.state, scene.target), reach};
}

Segment segment_of(const ScenePrimitive& line) {
  return {nearest_point(line.positions[0]), nearest_point(line.positions[1])};
}

bool possibly_covered(const ScenePrimitive& primitive, Point sample, Fixed reach) {
  switch (primitive.kind) {
    case PrimitiveKind::point:
      return point_possibly_covered(point_of(primitive), sample, reach);
    case PrimitiveKind::line:
      return multisampled_line_possibly_covered(segment_of(primitive), primitive.state->line_width,
                                                sample, reach);
    case PrimitiveKind::triangle:
      return triangle_possibly_covered(triangle_of(primitive), sample, reach);
  }
  return true;
}

bool possibly_uncovered(const ScenePrimitive& primitive, Point sample, Fixed reach) {
  switch (primitive.kind) {
    case PrimitiveKind::point:
      return point_possibly_uncovered(point_of(primitive), sample, reach);
    case PrimitiveKind::line:
      return multisampled_line_possibly_uncovered(segment_of(primitive),
                                                  primitive.state->line_width, sample, reach);
    case PrimitiveKind::triangle:
      return triangle_possibly_uncovered(triangle_of(primitive), sample, reach);
  }
  return true;
}

// How often a pixel is among pixels that are sorted row first.
long count(std::span<const PixelPosition> pixels, PixelPosition p) {
  const auto [first, last] = std::equal_range(
      pixels.begin(), pixels.end(), p,
      [](PixelPosition a, PixelPosition b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); });
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

// "less than 1/256 pixel", and what ruling 15 adds to it.
std::string move_of(Fixed error, int bits) {
  std::string text = fmt::format("less than 1/{} pixel", 1 << bits);
  if (error != Fixed())
    text += fmt::format(" and {:.2g} by the division by w (ruling 15)", error.to_double());
  return text;
}

// The common edge of two triangles whose ends are bit-identical, and not only nearest to one point.
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

// What two triangles have in common, how far vertices may move, and the pixels near it.
struct SharedSide {
  SharedEdge edge;
  Fixed reach;
  PixelBounds near;
};

// The samples that both triangles may write, by index, with where in a pixel they lie.
std::map<int, Point> shared_samples(const ScenePrimitive& first, const ScenePrimitive& second,
                                    const Target& target, const SamplePositions& positions) {
  if (!is_multisampled(*first.state, target)) return {{0, centre_of_pixel()}};
  const std::uint32_t mask = first.state->multisampling.mask & second.state->multisampling.mask;
  std::map<int, Point> samples;
  for (std::size_t s = 0; s < positions.size(); ++s)
    if ((mask >> s & 1) != 0) samples.emplace(static_cast<int>(s), positions[s]);
  return samples;
}

// Appends the pixels whose sample the two triangles do not hit once, though they must.
void add_faults(const SharedSide& side, int first, int second, int sample, Point within,
                std::span<const PrimitiveCoverage> coverage, std::vector<SharedEdgeFault>& faults) {
  const auto hits_of = [&](int primitive, PixelPosition p) {
    const SampleCoverage& drawn = coverage[static_cast<std::size_t>(primitive)].drawn;
    return count(drawn[static_cast<std::size_t>(sample)], p);
  };
  for (int y = side.near.y_min; y <= side.near.y_max; ++y) {
    for (int x = side.near.x_min; x <= side.near.x_max; ++x) {
      const long hits = hits_of(first, {x, y}) + hits_of(second, {x, y});
      if (hits == 1 || !must_hit_once(side.edge, place_in({x, y}, within), side.reach)) continue;
      faults.push_back({{x, y}, sample, first, second, static_cast<int>(hits)});
    }
  }
}

}  // namespace

int latitude_bits(int reported_subpixel_bits) {
  return std::clamp(reported_subpixel_bits, 4, Fixed::kFractionBits);
}

const char* rule_on_coverage(const ScenePrimitive& primitive, const Target& target) {
  if (primitive.is_clipped) return kClipVolume;
  const bool rectangle =
      primitive.kind == PrimitiveKind::line && is_multisampled(*primitive.state, target);
  return rectangle ? kMultisampledLine : coverage_rule_of(primitive.kind);
}

namespace {

// What no sample may be covered by, wherever the primitive lies; none.
std::optional<Legality> judge_mask(const ScenePrimitive& primitive,
                                   const CoverageDifference& difference) {
  const Multisampling& use = primitive.state->multisampling;
  if (difference.drawn == 0) return std::nullopt;
  if (!use.enabled && difference.sample > 0)
    return Legality{false, 35, "sample.enable",
                    "without GL_MULTISAMPLE a fragment has no sample but the first"};
  if (use.enabled && (use.mask >> difference.sample & 1) == 0)
    return Legality{false, 32, "sample.mask", "the sample is not in the draw's sample mask"};
  return std::nullopt;
}

}  // namespace

namespace {

// Of a primitive that reaches out of the clip volume: ruling 42.
Legality judge_clipped(const ScenePrimitive& primitive, bool extra, Point sample, int bits) {
  constexpr int kRuling = 42;
  if (primitive.kind != PrimitiveKind::triangle)
    return {!extra, kRuling, kClipVolume, "the vertex lies outside the clip volume"};
  const LoosePolygon polygon = loose_polygon(primitive, bits);
  const bool legal = extra ? polygon_possibly_covered(polygon, sample)
                           : polygon_possibly_uncovered(polygon, sample);
  return {legal, kRuling, kClipVolume,
          fmt::format("{} move of the vertices of what is seen, by less than 1/{} pixel and {:.2g} "
                      "by clipping and the division by w, {} the sample {}",
                      legal ? "some" : "no", 1 << bits,
                      division_error(primitive, primitive.viewport).to_double(),
                      legal ? "puts" : "could put",
                      extra ? "inside or on the boundary" : "outside or on the boundary")};
}

}  // namespace

Legality judge_sample(const ScenePrimitive& primitive, const CoverageDifference& difference,
                      Point within, const Viewport& viewport, int bits) {
  if (auto judged = judge_mask(primitive, difference)) return *judged;
  const bool point = primitive.kind == PrimitiveKind::point;
  const bool line = primitive.kind == PrimitiveKind::line;
  const bool extra = difference.drawn > difference.exact;
  const Point sample = place_in(difference.pixel, within);
  if (primitive.is_clipped) return judge_clipped(primitive, extra, sample, bits);
  Legality result;
  result.rule = line ? kMultisampledLine : coverage_rule_of(primitive.kind);
  result.ruling = point ? 6 : line ? 28 : 4;
  const Fixed reach = reach_of(primitive, viewport, bits);
  result.legal = extra ? possibly_covered(primitive, sample, reach)
                       : possibly_uncovered(primitive, sample, reach);
  result.reason =
      fmt::format("{} move of the {} by {} {} the sample {}", result.legal ? "some" : "no",
                  point ? "vertex" : "vertices", move_of(division_error(primitive, viewport), bits),
                  result.legal ? "puts" : "could put",
                  extra ? "inside or on the boundary" : "outside or on the boundary");
  return result;
}

Legality judge_facing(const ScenePrimitive& primitive, const CoverageDifference& difference,
                      bool whole, Legality otherwise, const Viewport& viewport, int bits) {
  constexpr const char* kRule = "polygon.facing";
  constexpr int kRuling = 40;
  if (primitive.kind != PrimitiveKind::triangle || primitive.state->cull == CullMode::none)
    return otherwise;
  const auto [may_be_culled, may_be_drawn] = permitted_culling(primitive, viewport, bits);
  const bool extra = difference.drawn > difference.exact;
  const bool turns = extra ? may_be_drawn : may_be_culled;
  const std::string reason =
      fmt::format("{} move of the vertices by {} turns the triangle so that it is {}culled",
                  turns ? "some" : "no", move_of(division_error(primitive, viewport), bits),
                  extra ? "not " : "");
  if (extra && !turns) return {false, kRuling, kRule, reason};
  if (extra && is_culled(primitive, primitive.positions, FacingMethod::as_set))
    return {otherwise.legal, kRuling, kRule,
            otherwise.legal ? reason : reason + ", but " + otherwise.reason};
  // All fragments of a triangle face one way.
  if (extra || !whole || otherwise.legal) return otherwise;
  return {turns, kRuling, kRule, "nothing of the triangle is drawn, and " + reason};
}

std::vector<std::string> illegal_line_snaps(const ScenePrimitive& line,
                                            std::span<const PixelPosition> drawn,
                                            const Scene& scene) {
  std::vector<std::string> result;
  for (Snap snap : all_snaps())
    if (!broken_line_clause(seen_line(line, snap, scene), drawn).empty())
      result.push_back(name_of(snap));
  return result;
}

std::string broken_clause_unsnapped(const ScenePrimitive& line,
                                    std::span<const PixelPosition> drawn, const Scene& scene) {
  return broken_line_clause(seen_line(line, Snap{}, scene), drawn);
}

int ruling_on_line(const ScenePrimitive& line, const Scene& scene) {
  const SeenLine seen = seen_line(line, Snap{}, scene);
  if (seen.width != 1) return 12;
  return is_unseen(seen) ? 2 : 1;
}

bool is_about_a_line(const Disagreement& disagreement) {
  return disagreement.rule == "line.diamond-exit" || disagreement.rule == "line.joint";
}

std::vector<SharedEdgeFault> shared_edge_faults(std::span<const ScenePrimitive> primitives,
                                                std::span<const PrimitiveCoverage> coverage,
                                                const Scene& scene, int bits,
                                                const SamplePositions& positions) {
  std::vector<SharedEdgeFault> faults;
  // Ruling 40 lets others be missing, or has them so.
  const auto is_drawn = [&](const ScenePrimitive& p) {
    // What clipping makes of two triangles need not have an edge in common.
    return p.kind == PrimitiveKind::triangle && !p.is_clipped &&
           !permitted_culling(p, scene.viewport, bits).may_be_culled;
  };
  const auto multisampled = [&](const ScenePrimitive& p) {
    return is_multisampled(*p.state, scene.target);
  };
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    for (std::size_t j = i + 1; j < primitives.size(); ++j) {
      if (!is_drawn(primitives[i]) || !is_drawn(primitives[j])) continue;
      if (multisampled(primitives[i]) != multisampled(primitives[j])) continue;
      const auto edge = common_edge(primitives[i], primitives[j]);
      if (!edge) continue;
      const Fixed reach = std::max(reach_of(primitives[i], scene.viewport, bits),
                                   reach_of(primitives[j], scene.viewport, bits));
      const PixelBounds near =
          bounds_near(edge->a, edge->b,
                      common(drawable_bounds(*primitives[i].state, scene.target),
                             drawable_bounds(*primitives[j].state, scene.target)));
      const SharedSide side{*edge, reach, near};
      for (const auto& [sample, within] :
           shared_samples(primitives[i], primitives[j], scene.target, positions))
        add_faults(side, primitives[i].index, primitives[j].index, sample, within, coverage,
                   faults);
    }
  }
  return faults;
}

}  // namespace edgecase
