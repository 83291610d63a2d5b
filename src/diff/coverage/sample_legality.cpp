// SPDX-License-Identifier: MIT
#include "diff/coverage/sample_legality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diff/coverage/covered_shape.h"
#include "exact/numeral.h"
#include "model/side_clipping.h"
#include "rules/coverage/homogeneous_triangle.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/samples/sample_placement.h"

namespace edgecase {
namespace {

constexpr Fixed kHalf = Fixed::from_raw(Fixed::kOne / 2);

// "less than 1/256 pixel", with the addition of ruling 15; or its error alone, if that is larger.
std::string move_of(Fixed error, int bits, Fixed reach = {}) {
  if (reach > grid_step(bits) + error)
    return fmt::format("less than {:.2g} pixel (ruling 15)", reach.to_double());
  std::string text = fmt::format("less than 1/{} pixel", 1 << bits);
  if (error != Fixed())
    text += fmt::format(" and {:.2g} by the division by w (ruling 15)", error.to_double());
  return text;
}

// ", with a size of 1 to 4,": the sizes that an unsupported one may become.
std::string text_of(const SizeRange& sizes) {
  if (sizes.low == sizes.high) return "";
  return fmt::format(", with a size of {} to {},", to_decimal(sizes.low), to_decimal(sizes.high));
}

// The reason why no primitive may cover the sample, wherever it lies; none if there is no reason.
std::optional<CoverageLegality> judge_mask(const ScenePrimitive& primitive,
                                           const CoverageDifference& difference) {
  const Multisampling& use = primitive.state->multisampling;
  if (difference.drawn == 0) return std::nullopt;
  if (!use.enabled && difference.sample > 0)
    return legality_under(RuleId::sample_enable, false,
                          "without GL_MULTISAMPLE a fragment has no sample but the first");
  if (use.enabled && (use.mask >> difference.sample & 1) == 0)
    return legality_under(RuleId::sample_mask, false,
                          "the sample is not in the draw's sample mask");
  return std::nullopt;
}

std::pair<int, int> row_and_column(PixelPosition pixel) {
  return {pixel.y, pixel.x};
}

// A point outside the clip volume that clipping may still pass: it lies between near and far, to
// within 1 part in 10^5 of w, and near enough to the target to have a position in the window.
std::optional<SizedPoint> passed_point(const ScenePrimitive& point) {
  const ClipPosition& clip = *point.vertices[0]->clip;
  const double farthest = static_cast<double>(clip.w) * (1 + 1e-5);
  if (!(clip.w > 0) || std::fabs(static_cast<double>(clip.z)) > farthest) return std::nullopt;
  const HomogeneousPoint& place = point.positions[0];
  const std::int64_t limit = Fixed::kMaxCoordinate * place.w;
  if (std::abs(place.x) > limit || std::abs(place.y) > limit) return std::nullopt;
  return SizedPoint{nearest_point(place), point.state->point_size};
}

// True if a cut at the viewport's sides makes the difference.
bool is_cut_at_viewport(const ScenePrimitive& primitive, const CoverageDifference& difference) {
  return primitive.kind != PrimitiveKind::triangle && difference.drawn < difference.exact &&
         !pixels_in(primitive.viewport).contains(difference.pixel);
}

bool is_extra(const CoverageDifference& difference) {
  return difference.drawn > difference.exact;
}

// True if two vertices are one, wherever vertices are moved, so that there is no area.
bool is_without_area(const ScenePrimitive& primitive) {
  if (primitive.kind != PrimitiveKind::triangle) return false;
  const auto& v = primitive.vertices;
  return is_bit_identical(*v[0], *v[1]) || is_bit_identical(*v[1], *v[2]) ||
         is_bit_identical(*v[2], *v[0]);
}

}  // namespace

// What exact covers may have holes, too, if fragments are left out for other reasons.
ShapeFault shape_fault(const ScenePrimitive& primitive, const PrimitiveCoverage& coverage,
                       const Target& target) {
  if (primitive.kind != PrimitiveKind::triangle || primitive.is_clipped ||
      is_multisampled(*primitive.state, target))
    return {};
  ShapeFault fault;
  const std::vector<PixelPosition>& exact = coverage.exact.front();
  const Triangle triangle = nearest_triangle(primitive.positions);
  const Fixed error = std::max(division_error(primitive), Fixed::from_raw(1));
  const auto is_on_edge = [&](PixelPosition pixel) {
    const Point centre = pixel_centre(pixel.x, pixel.y);
    return triangle_possibly_covered(triangle, centre, error) &&
           triangle_possibly_uncovered(triangle, centre, error);
  };
  std::optional<PixelHull> hull;  // of exact; most triangles need none
  for (const auto& [hole, is_on_border] : holes_in(coverage.drawn.front())) {
    if (is_on_border && is_on_edge(hole)) continue;
    if (std::ranges::binary_search(exact, row_and_column(hole), {}, row_and_column)) {
      fault.holes.push_back(hole);
      continue;
    }
    if (!hull) hull.emplace(exact);
    if (!fault.hole_beyond && !hull->contains(hole)) fault.hole_beyond = hole;
  }
  return fault;
}

SampleJudge::SampleJudge(const ScenePrimitive& primitive, const SampleTerms& terms)
    : primitive_(primitive),
      terms_(terms),
      error_(division_error(primitive)),
      latitudes_(latitudes_of(primitive, terms.bits, terms.sizes)),
      culling_(permitted_culling(primitive, terms.bits)) {
  if (primitive.is_clipped && primitive.kind == PrimitiveKind::triangle)
    polygon_ = loose_polygon(primitive, terms.bits);
}

CoverageLegality SampleJudge::judged(const CoverageDifference& difference, Point within,
                                     bool wants_reason) {
  wants_reason_ = wants_reason;
  CoverageLegality legality = judge(difference, within);
  if (!legality.legal) contest(difference, legality);
  return judge_facing(difference, std::move(legality));
}

bool SampleJudge::is_possible(Point sample, bool extra, Fixed more) const {
  Latitudes latitudes = latitudes_;
  latitudes.reach = latitudes.reach + more;
  return extra ? possibly_covered(primitive_, sample, latitudes)
               : possibly_uncovered(primitive_, sample, latitudes);
}

// An implementation may draw a point outside the sides of the view volume, or not; exact does not
// (ruling 42).
CoverageLegality SampleJudge::judge_clipped_point(bool extra, Point sample) const {
  const auto passed = passed_point(primitive_);
  if (!passed || !extra)
    return legality_under(kClipVolume, !extra,
                          passed ? "the point lies outside the view volume, and may be discarded"
                                 : "the point does not lie between near and far");
  const Vertex& vertex = *primitive_.vertices[0];
  const Fixed error = edgecase::division_error(vertex, passed->vertex, primitive_.viewport);
  if (point_possibly_covered(*passed, sample, grid_step(terms_.bits) + error))
    return legality_under(kClipVolume, true,
                          "the point lies between near and far, and so need not be discarded");
  return legality_under(
      RuleId::point_ownership, false, reason([&] {
        return fmt::format(
            "no move of the vertex by {} could put the sample inside or on the boundary",
            move_of(error, terms_.bits));
      }));
}

// Judges a primitive that reaches out of the clip volume: ruling 42.
CoverageLegality SampleJudge::judge_clipped(bool extra, Point sample) const {
  if (primitive_.kind == PrimitiveKind::point) return judge_clipped_point(extra, sample);
  if (primitive_.kind == PrimitiveKind::line)
    return legality_under(kClipVolume, !extra, "nothing of the line lies in the clip volume");
  const bool legal = extra ? polygon_possibly_covered(*polygon_, sample)
                           : polygon_possibly_uncovered(*polygon_, sample);
  return legality_under(
      kClipVolume, legal, reason([&] {
        return fmt::format(
            "{} move of the vertices of what is seen, by less than 1/{} pixel and {:.2g} "
            "by clipping and the division by w, {} the sample {}",
            legal ? "some" : "no", 1 << terms_.bits, error_.to_double(),
            legal ? "puts" : "could put",
            extra ? "inside or on the boundary" : "outside or on the boundary");
      }));
}

bool SampleJudge::is_clipped_as_in_opengl(Point sample) const {
  if (primitive_.clips_sides || !leaves_sides(primitive_)) return false;
  const ScenePrimitive cut = with_sides(primitive_, true);
  return cut.is_clipped ||
         possibly_uncovered(cut, sample, latitudes_of(cut, terms_.bits, terms_.sizes));
}

CoverageLegality SampleJudge::judge(const CoverageDifference& difference, Point within) const {
  if (auto masked = judge_mask(primitive_, difference)) return *std::move(masked);
  if (auto shape = judge_shape(difference)) return *std::move(shape);
  const bool point = primitive_.kind == PrimitiveKind::point;
  const bool line = primitive_.kind == PrimitiveKind::line;
  const bool extra = is_extra(difference);
  const Point sample = place_in(difference.pixel, within);
  if (primitive_.is_clipped) return judge_clipped(extra, sample);
  CoverageLegality result = legality_under(
      line ? kMultisampledLine : coverage_rule_of(primitive_.kind), is_possible(sample, extra));
  result.reason = reason([&] {
    const bool is_sized = primitive_.kind != PrimitiveKind::triangle;
    return fmt::format(
        "{} move of the {} by {}{} {} the sample {}", result.legal ? "some" : "no",
        point ? "vertex" : "vertices", move_of(error_, terms_.bits, latitudes_.reach),
        is_sized ? text_of(latitudes_.sizes) : "", result.legal ? "puts" : "could put",
        extra ? "inside or on the boundary" : "outside or on the boundary");
  });
  if (result.legal || extra || !is_clipped_as_in_opengl(sample)) return result;
  result.rule = kClipVolume;
  result.ruling = kRulingOnSides;
  result.reason +=
      reason([] { return ", and the viewport's sides clip no point and no line in OpenGL ES"; });
  return result;
}

std::optional<CoverageLegality> SampleJudge::judge_shape(
    const CoverageDifference& difference) const {
  CoverageLegality broken = legality_under(RuleId::triangle_fill_rule, false);
  const ShapeFault& shape = terms_.shape;
  if (is_extra(difference)) {
    if (is_without_area(primitive_)) {
      broken.reason = reason([] {
        return std::string("two vertices are one, so that the triangle has no area after any move");
      });
      return broken;
    }
    if (!shape.hole_beyond) return std::nullopt;
    broken.reason = reason([&] {
      return fmt::format(
          "pixel ({}, {}) is left out and lies between those that the triangle covers, and no move "
          "of the vertices makes a triangle of that shape",
          shape.hole_beyond->x, shape.hole_beyond->y);
    });
    return broken;
  }
  if (!std::ranges::binary_search(shape.holes, row_and_column(difference.pixel), {},
                                  row_and_column))
    return std::nullopt;
  broken.reason = reason([] {
    return std::string(
        "it lies between samples that the triangle covers, which no move of the vertices makes a "
        "triangle leave out");
  });
  return broken;
}

CoverageLegality SampleJudge::judge_facing(const CoverageDifference& difference,
                                           CoverageLegality otherwise) const {
  constexpr RuleId kRule = RuleId::polygon_facing;
  if (primitive_.kind != PrimitiveKind::triangle || primitive_.state->cull == CullMode::none)
    return otherwise;
  const auto [may_be_culled, may_be_drawn] = culling_;
  const bool extra = is_extra(difference);
  const bool turns = extra ? may_be_drawn : may_be_culled;
  const std::string facing = reason([&] {
    return fmt::format("{} move of the vertices by {} turns the triangle so that it is {}culled",
                       turns ? "some" : "no", move_of(error_, terms_.bits, latitudes_.reach),
                       extra ? "not " : "");
  });
  if (extra && !turns) return legality_under(kRule, false, facing);
  if (extra && is_culled(primitive_, primitive_.positions, FacingMethod::as_set))
    return legality_under(kRule, otherwise.legal,
                          otherwise.legal ? facing : facing + ", but " + otherwise.reason);
  // All fragments of a triangle face the same way.
  if (extra || !terms_.is_missing || otherwise.legal) return otherwise;
  return legality_under(kRule, turns, "nothing of the triangle is drawn, and " + facing);
}

// A sample at most half a pixel from a centre is like a centre with the vertices moved by as much;
// the pixel and its surroundings are those squares round nine centres.
bool SampleJudge::is_so_elsewhere(PixelPosition pixel, bool extra) {
  if (primitive_.is_clipped && !polygon_) return false;
  // The samples of a pixel have one answer.
  const auto [known, is_new] = elsewhere_.try_emplace({pixel, extra}, false);
  if (!is_new) return known->second;
  LoosePolygon polygon = polygon_ ? *polygon_ : LoosePolygon{};
  polygon.reach = polygon.reach + kHalf;
  const auto is_so = [&](Point sample) {
    if (!polygon_) return is_possible(sample, extra, kHalf);
    return extra ? polygon_possibly_covered(polygon, sample)
                 : polygon_possibly_uncovered(polygon, sample);
  };
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (is_so(pixel_centre(pixel.x + dx, pixel.y + dy))) return known->second = true;
  return false;
}

void SampleJudge::contest(const CoverageDifference& difference, CoverageLegality& legality) {
  if (judge_mask(primitive_, difference) || judge_shape(difference)) return;
  if (is_cut_at_viewport(primitive_, difference)) {
    legality.ruling = kRulingOnViewport;
    legality.reason += ", and the pixel lies beyond the viewport's sides";
  } else if (terms_.is_multisampled && is_so_elsewhere(difference.pixel, is_extra(difference))) {
    if (terms_.places != nullptr && !terms_.places->of(difference.sample)) {
      legality.reason +=
          reason([] { return ", and no one place of the sample explains all that it covers"; });
      return;
    }
    legality.ruling = kRulingOnOtherPlaces;
    legality.reason += reason([&] {
      return fmt::format(", but a sample elsewhere could be {}",
                         is_extra(difference) ? "covered" : "left out");
    });
  }
}

CoverageLegality judge_sample(const ScenePrimitive& primitive, const CoverageDifference& difference,
                              Point within, int bits, const SupportedSizes& sizes) {
  return SampleJudge(primitive, {bits, sizes}).judge(difference, within);
}

}  // namespace edgecase
