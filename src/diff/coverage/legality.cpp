// SPDX-License-Identifier: MIT
#include "diff/coverage/legality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "diff/coverage/vertex_latitude.h"
#include "raster/coverage_stages.h"
#include "raster/rasterizer.h"
#include "rules/choices.h"
#include "rules/coverage/line_algorithm.h"
#include "rules/coverage/line_latitude.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/triangle_algorithm.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/coverage/window.h"
#include "rules/samples/multisampled_line.h"

namespace edgecase {
namespace {

// Quotients are rounded to the nearest point; reach_of accounts for the error.
Triangle triangle_of(const ScenePrimitive& primitive) {
  return nearest_triangle(primitive.positions);
}

SizedPoint point_of(const ScenePrimitive& primitive) {
  return {nearest_point(primitive.positions[0]), primitive.state->point_size};
}

// SeenLine::find, with kernels if they are in use.
std::vector<PixelPosition> fragments_of_rule(const Segment& segment, const PixelBounds& bounds) {
  static const CoverageChoice choice = [] {
    CoverageChoice standard;
    standard.line.boundary = find_diamond_boundary("left-bottom");
    return standard;
  }();
  return found_line_pixels(segment, Fixed::from_integer(1), bounds, choice);
}

// The terms by which a line is judged: its permitted widths, the pixels that are tested, and what
// is the same under every snap.
struct LineTerms {
  std::vector<int> widths;
  PixelBounds bounds;
  EndErrors errors;
};

// The nearest integers to the width: two for a half, since 14.5.2.2 does not decide ties.
LineTerms terms_of(const ScenePrimitive& line, const Scene& scene) {
  const Fixed width = line.state->line_width;
  LineTerms terms{
      {rounded_width(width)}, drawable_bounds(*line.state, scene.target), end_errors(line)};
  const bool is_half = width.raw() % Fixed::kOne == Fixed::kOne / 2;
  if (is_half && terms.widths[0] > 1) terms.widths.push_back(terms.widths[0] - 1);
  return terms;
}

SeenLine seen_line(const ScenePrimitive& line, Snap snap, const LineTerms& terms) {
  const auto [segment, reach] = snapped_segment(line, snap, terms.errors);
  return {segment, terms.widths[0], terms.bounds, reach, fragments_of_rule};
}

// The clause that is broken for every permitted width.
std::string broken_clause(SeenLine line, const LineTerms& terms,
                          std::span<const PixelPosition> drawn) {
  std::string first;
  for (const int width : terms.widths) {
    line.width = width;
    const std::string clause = broken_line_clause(line, drawn);
    if (clause.empty()) return "";
    if (first.empty()) first = clause;
  }
  return first;
}

Segment segment_of(const ScenePrimitive& line) {
  return {nearest_point(line.positions[0]), nearest_point(line.positions[1])};
}

// The permitted size of a point or width of a multisampled line. A multisampled point smaller than
// the fade threshold, which is 1, may be as large as the threshold (14.4, equation 14.1).
SizeRange sizes_of(const ScenePrimitive& primitive, const SupportedSizes& supported) {
  const Draw& state = *primitive.state;
  if (primitive.kind == PrimitiveKind::line)
    return permitted_sizes(state.line_width, supported.lines);
  SizeRange range = permitted_sizes(state.point_size, supported.points);
  if (state.multisampling.enabled && state.point_size < Fixed::from_integer(1))
    range.high = std::max(range.high, Fixed::from_integer(1));
  return range;
}

// The latitude of vertices, and of sizes of points and lines.
struct Latitudes {
  Fixed reach;
  SizeRange sizes;
};

bool possibly_covered(const ScenePrimitive& primitive, Point sample, const Latitudes& latitudes) {
  const auto& [reach, sizes] = latitudes;
  switch (primitive.kind) {
    case PrimitiveKind::point:
      return point_possibly_covered({point_of(primitive).vertex, sizes.high}, sample, reach);
    case PrimitiveKind::line:
      return multisampled_line_possibly_covered(segment_of(primitive), sizes.high, sample, reach);
    case PrimitiveKind::triangle:
      return triangle_possibly_covered(triangle_of(primitive), sample, reach);
  }
  return true;
}

bool possibly_uncovered(const ScenePrimitive& primitive, Point sample, const Latitudes& latitudes) {
  const auto& [reach, sizes] = latitudes;
  switch (primitive.kind) {
    case PrimitiveKind::point:
      return point_possibly_uncovered({point_of(primitive).vertex, sizes.low}, sample, reach);
    case PrimitiveKind::line:
      return multisampled_line_possibly_uncovered(segment_of(primitive), sizes.low, sample, reach);
    case PrimitiveKind::triangle:
      return triangle_possibly_uncovered(triangle_of(primitive), sample, reach);
  }
  return true;
}

// "less than 1/256 pixel", with the addition of ruling 15.
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

RuleId rule_on_coverage(const ScenePrimitive& primitive, const Target& target) {
  if (primitive.is_clipped) return kClipVolume;
  const bool rectangle =
      primitive.kind == PrimitiveKind::line && is_multisampled(*primitive.state, target);
  return rectangle ? kMultisampledLine : coverage_rule_of(primitive.kind);
}

namespace {

// The reason why no primitive may cover the sample, wherever it lies; none if there is no reason.
std::optional<CoverageLegality> judge_mask(const ScenePrimitive& primitive,
                                           const CoverageDifference& difference) {
  const Multisampling& use = primitive.state->multisampling;
  if (difference.drawn == 0) return std::nullopt;
  if (!use.enabled && difference.sample > 0)
    return CoverageLegality{false, 35, RuleId::sample_enable,
                            "without GL_MULTISAMPLE a fragment has no sample but the first"};
  if (use.enabled && (use.mask >> difference.sample & 1) == 0)
    return CoverageLegality{false, 32, RuleId::sample_mask,
                            "the sample is not in the draw's sample mask"};
  return std::nullopt;
}

}  // namespace

namespace {

// A point outside the clip volume that clipping may still pass: it lies between near and far, to
// within 1 part in 10^5 of w, and near enough to the target to have a position in the window.
std::optional<SizedPoint> passed_point(const ScenePrimitive& point) {
  const ClipPosition& clip = *point.vertices[0]->clip;
  const double farthest = static_cast<double>(clip.w) * (1 + 1e-5);
  if (!(clip.w > 0) || std::fabs(static_cast<double>(clip.z)) > farthest) return std::nullopt;
  const HomogeneousPoint& place = point.positions[0];
  const std::int64_t limit = Fixed::kMaxCoordinate * place.w;
  if (std::abs(place.x) > limit || std::abs(place.y) > limit) return std::nullopt;
  return point_of(point);
}

// An implementation may draw a point outside the sides of the view volume, or not; exact does not
// (ruling 42).
CoverageLegality judge_clipped_point(const ScenePrimitive& point, bool extra, Point sample,
                                     int bits) {
  constexpr int kRuling = 42;
  const auto passed = passed_point(point);
  if (!passed || !extra)
    return {!extra, kRuling, kClipVolume,
            passed ? "the point lies outside the view volume, and may be discarded"
                   : "the point does not lie between near and far"};
  const Vertex& vertex = *point.vertices[0];
  const Fixed error = division_error(vertex, passed->vertex, point.viewport);
  if (point_possibly_covered(*passed, sample, grid_step(bits) + error))
    return {true, kRuling, kClipVolume,
            "the point lies between near and far, and so need not be discarded"};
  return {false, 6, coverage_rule_of(point.kind),
          fmt::format("no move of the vertex by {} could put the sample inside or on the boundary",
                      move_of(error, bits))};
}

// Judges a primitive that reaches out of the clip volume: ruling 42.
CoverageLegality judge_clipped(const ScenePrimitive& primitive, bool extra, Point sample,
                               int bits) {
  constexpr int kRuling = 42;
  if (primitive.kind == PrimitiveKind::point)
    return judge_clipped_point(primitive, extra, sample, bits);
  if (primitive.kind == PrimitiveKind::line)
    return {!extra, kRuling, kClipVolume, "nothing of the line lies in the clip volume"};
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
                              Point within, int bits, const SupportedSizes& sizes) {
  if (auto judged = judge_mask(primitive, difference)) return *judged;
  const bool point = primitive.kind == PrimitiveKind::point;
  const bool line = primitive.kind == PrimitiveKind::line;
  const bool extra = difference.drawn > difference.exact;
  const Point sample = place_in(difference.pixel, within);
  if (primitive.is_clipped) return judge_clipped(primitive, extra, sample, bits);
  CoverageLegality result;
  result.rule = line ? kMultisampledLine : coverage_rule_of(primitive.kind);
  result.ruling = point ? 6 : line ? 28 : 4;
  const Latitudes latitudes{reach_of(primitive, bits), sizes_of(primitive, sizes)};
  result.legal = extra ? possibly_covered(primitive, sample, latitudes)
                       : possibly_uncovered(primitive, sample, latitudes);
  result.reason =
      fmt::format("{} move of the {} by {} {} the sample {}", result.legal ? "some" : "no",
                  point ? "vertex" : "vertices", move_of(division_error(primitive), bits),
                  result.legal ? "puts" : "could put",
                  extra ? "inside or on the boundary" : "outside or on the boundary");
  return result;
}

CoverageLegality judge_facing(const ScenePrimitive& primitive, const CoverageDifference& difference,
                              bool whole, CoverageLegality otherwise, int bits) {
  constexpr RuleId kRule = RuleId::polygon_facing;
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
  // All fragments of a triangle face the same way.
  if (extra || !whole || otherwise.legal) return otherwise;
  return {turns, kRuling, kRule, "nothing of the triangle is drawn, and " + reason};
}

namespace {

// True if a sample elsewhere in the pixel, or less than a pixel outside it, would be covered (or
// not) as the difference has it.
bool is_so_elsewhere(const ScenePrimitive& primitive, const CoverageDifference& difference,
                     int bits, const SupportedSizes& sizes) {
  const bool extra = difference.drawn > difference.exact;
  const Fixed half = Fixed::from_raw(Fixed::kOne / 2);
  LoosePolygon polygon;
  if (primitive.is_clipped) {
    if (primitive.kind != PrimitiveKind::triangle) return false;
    polygon = loose_polygon(primitive, bits);
    polygon.reach = polygon.reach + half;
  }
  const Latitudes latitudes{reach_of(primitive, bits) + half, sizes_of(primitive, sizes)};
  const auto is_so = [&](Point sample) {
    if (primitive.is_clipped)
      return extra ? polygon_possibly_covered(polygon, sample)
                   : polygon_possibly_uncovered(polygon, sample);
    return extra ? possibly_covered(primitive, sample, latitudes)
                 : possibly_uncovered(primitive, sample, latitudes);
  };
  // A sample at most half a pixel from a centre is like a centre with the vertices moved by as
  // much; the pixel and its surroundings are those squares round nine centres.
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (is_so(pixel_centre(difference.pixel.x + dx, difference.pixel.y + dy))) return true;
  return false;
}

// True if a cut at the viewport's sides makes the difference.
bool is_cut_at_viewport(const ScenePrimitive& primitive, const CoverageDifference& difference) {
  return primitive.kind != PrimitiveKind::triangle && difference.drawn < difference.exact &&
         !pixels_in(primitive.viewport).contains(difference.pixel);
}

}  // namespace

void contest(const ScenePrimitive& primitive, const CoverageDifference& difference,
             const ContestTerms& terms, CoverageLegality& legality) {
  if (judge_mask(primitive, difference)) return;
  if (is_cut_at_viewport(primitive, difference)) {
    legality.ruling = kRulingOnViewport;
    legality.reason += ", and the pixel lies beyond the viewport's sides";
  } else if (terms.is_multisampled &&
             is_so_elsewhere(primitive, difference, terms.bits, terms.sizes)) {
    legality.ruling = kRulingOnOtherPlaces;
    legality.reason += fmt::format(", but a sample elsewhere could be {}",
                                   difference.drawn > difference.exact ? "covered" : "left out");
  }
}

namespace {

std::vector<std::string> snaps_that_break(const ScenePrimitive& line,
                                          std::span<const PixelPosition> drawn,
                                          const LineTerms& terms) {
  // Many snaps leave a line where it is; each position is judged once.
  std::vector<std::pair<SeenLine, bool>> judged;
  std::vector<std::string> result;
  for (Snap snap : all_snaps()) {
    const SeenLine seen = seen_line(line, snap, terms);
    auto found = std::find_if(judged.begin(), judged.end(), [&](const auto& known) {
      return known.first.segment.a == seen.segment.a && known.first.segment.b == seen.segment.b &&
             known.first.reach == seen.reach;
    });
    if (found == judged.end())
      found = judged.insert(found, {seen, !broken_clause(seen, terms, drawn).empty()});
    if (found->second) result.push_back(name_of(snap));
  }
  return result;
}

}  // namespace

std::vector<std::string> illegal_line_snaps(const ScenePrimitive& line,
                                            std::span<const PixelPosition> drawn,
                                            const Scene& scene) {
  return snaps_that_break(line, drawn, terms_of(line, scene));
}

namespace {

// True for one fragment at most one unit from a pixel whose closed diamond the segment meets.
bool is_near_empty_line(const SeenLine& line, std::span<const PixelPosition> drawn) {
  if (line.width != 1 || drawn.size() != 1 || !is_unseen(line)) return false;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (may_meet_diamond({line.segment, line.reach}, {drawn[0].x + dx, drawn[0].y + dy}))
        return true;
  return false;
}

}  // namespace

int contested_ruling_on_line(const ScenePrimitive& line, std::span<const PixelPosition> drawn,
                             const Scene& scene) {
  const LineTerms terms = terms_of(line, scene);
  if (is_near_empty_line(seen_line(line, Snap{}, terms), drawn)) return kRulingOnEmptyLine;
  const std::size_t broken = snaps_that_break(line, drawn, terms).size();
  const auto holds_under_more = [&](const LineTerms& other) {
    return snaps_that_break(line, drawn, other).size() < broken;
  };
  const PixelBounds viewport = common_part(terms.bounds, pixels_in(line.viewport));
  const bool is_inside =
      std::ranges::all_of(drawn, [&](PixelPosition pixel) { return viewport.contains(pixel); });
  if (viewport != terms.bounds && is_inside &&
      holds_under_more({terms.widths, viewport, terms.errors}))
    return kRulingOnViewport;
  const Fixed width = line.state->line_width;
  const int smaller = static_cast<int>(width.floor());
  const bool is_smaller = smaller >= 1 && smaller < terms.widths.back();
  if (is_smaller && holds_under_more({{smaller}, terms.bounds, terms.errors}))
    return kRulingOnSmallerWidth;
  return 0;
}

std::string broken_clause_unsnapped(const ScenePrimitive& line,
                                    std::span<const PixelPosition> drawn, const Scene& scene) {
  const LineTerms terms = terms_of(line, scene);
  return broken_clause(seen_line(line, Snap{}, terms), terms, drawn);
}

int ruling_on_line(const ScenePrimitive& line, const Scene& scene) {
  const SeenLine seen = seen_line(line, Snap{}, terms_of(line, scene));
  if (seen.width != 1) return 12;
  return is_unseen(seen) ? 2 : 1;
}

bool is_about_a_line(const Disagreement& disagreement) {
  return disagreement.rule == RuleId::line_diamond_exit || disagreement.rule == RuleId::line_joint;
}

}  // namespace edgecase
