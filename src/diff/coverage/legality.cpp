// SPDX-License-Identifier: MIT
#include "diff/coverage/legality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "diff/coverage/facing_latitude.h"
#include "diff/values/vertex_latitude.h"
#include "raster/fast_coverage.h"
#include "raster/rasterizer.h"
#include "rules/choices.h"
#include "rules/coverage/homogeneous_triangle.h"
#include "rules/coverage/line_algorithm.h"
#include "rules/coverage/line_latitude.h"
#include "rules/coverage/point_ownership.h"
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

// SeenLine::find, by kernels where they are used.
std::vector<PixelPosition> fragments_of_rule(const Segment& segment, const PixelBounds& bounds) {
  static const CoverageChoice choice = [] {
    CoverageChoice standard;
    standard.line.boundary = find_diamond_boundary("left-bottom");
    return standard;
  }();
  return found_line_pixels(segment, Fixed::from_integer(1), bounds, choice);
}

SeenLine seen_line(const ScenePrimitive& line, Snap snap, const Scene& scene) {
  const auto [segment, reach] = snapped_segment(line, snap);
  return {segment, rounded_width(line.state->line_width),
          drawable_bounds(*line.state, scene.target), reach, fragments_of_rule};
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

// "less than 1/256 pixel", and what ruling 15 adds to it.
std::string move_of(Fixed error, int bits) {
  std::string text = fmt::format("less than 1/{} pixel", 1 << bits);
  if (error != Fixed())
    text += fmt::format(" and {:.2g} by the division by w (ruling 15)", error.to_double());
  return text;
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
std::optional<CoverageLegality> judge_mask(const ScenePrimitive& primitive,
                                           const CoverageDifference& difference) {
  const Multisampling& use = primitive.state->multisampling;
  if (difference.drawn == 0) return std::nullopt;
  if (!use.enabled && difference.sample > 0)
    return CoverageLegality{false, 35, "sample.enable",
                            "without GL_MULTISAMPLE a fragment has no sample but the first"};
  if (use.enabled && (use.mask >> difference.sample & 1) == 0)
    return CoverageLegality{false, 32, "sample.mask",
                            "the sample is not in the draw's sample mask"};
  return std::nullopt;
}

}  // namespace

namespace {

// Of a primitive that reaches out of the clip volume: ruling 42.
CoverageLegality judge_clipped(const ScenePrimitive& primitive, bool extra, Point sample,
                               int bits) {
  constexpr int kRuling = 42;
  if (primitive.kind != PrimitiveKind::triangle)
    return {!extra, kRuling, kClipVolume, "the vertex lies outside the clip volume"};
  const LoosePolygon polygon = loose_polygon(primitive, bits);
  const bool legal = extra ? polygon_possibly_covered(polygon, sample)
                           : polygon_possibly_uncovered(polygon, sample);
  return {legal, kRuling, kClipVolume,
          fmt::format("{} move of the vertices of what is seen, by less than 1/{} pixel and {:.2g} "
                      "by clipping and the division by w, {} the sample {}",
                      legal ? "some" : "no", 1 << bits, division_error(primitive).to_double(),
                      legal ? "puts" : "could put",
                      extra ? "inside or on the boundary" : "outside or on the boundary")};
}

}  // namespace

CoverageLegality judge_sample(const ScenePrimitive& primitive, const CoverageDifference& difference,
                              Point within, int bits) {
  if (auto judged = judge_mask(primitive, difference)) return *judged;
  const bool point = primitive.kind == PrimitiveKind::point;
  const bool line = primitive.kind == PrimitiveKind::line;
  const bool extra = difference.drawn > difference.exact;
  const Point sample = place_in(difference.pixel, within);
  if (primitive.is_clipped) return judge_clipped(primitive, extra, sample, bits);
  CoverageLegality result;
  result.rule = line ? kMultisampledLine : coverage_rule_of(primitive.kind);
  result.ruling = point ? 6 : line ? 28 : 4;
  const Fixed reach = reach_of(primitive, bits);
  result.legal = extra ? possibly_covered(primitive, sample, reach)
                       : possibly_uncovered(primitive, sample, reach);
  result.reason =
      fmt::format("{} move of the {} by {} {} the sample {}", result.legal ? "some" : "no",
                  point ? "vertex" : "vertices", move_of(division_error(primitive), bits),
                  result.legal ? "puts" : "could put",
                  extra ? "inside or on the boundary" : "outside or on the boundary");
  return result;
}

CoverageLegality judge_facing(const ScenePrimitive& primitive, const CoverageDifference& difference,
                              bool whole, CoverageLegality otherwise, int bits) {
  constexpr const char* kRule = "polygon.facing";
  constexpr int kRuling = 40;
  if (primitive.kind != PrimitiveKind::triangle || primitive.state->cull == CullMode::none)
    return otherwise;
  const auto [may_be_culled, may_be_drawn] = permitted_culling(primitive, bits);
  const bool extra = difference.drawn > difference.exact;
  const bool turns = extra ? may_be_drawn : may_be_culled;
  const std::string reason = fmt::format(
      "{} move of the vertices by {} turns the triangle so that it is {}culled",
      turns ? "some" : "no", move_of(division_error(primitive), bits), extra ? "not " : "");
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
  // Many snaps leave a line in the same place, where it is judged once.
  std::vector<std::pair<SeenLine, bool>> judged;
  std::vector<std::string> result;
  for (Snap snap : all_snaps()) {
    const SeenLine seen = seen_line(line, snap, scene);
    auto found = std::find_if(judged.begin(), judged.end(), [&](const auto& known) {
      return known.first.segment.a == seen.segment.a && known.first.segment.b == seen.segment.b &&
             known.first.reach == seen.reach;
    });
    if (found == judged.end())
      found = judged.insert(found, {seen, !broken_line_clause(seen, drawn).empty()});
    if (found->second) result.push_back(name_of(snap));
  }
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

}  // namespace edgecase
