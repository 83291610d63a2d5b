// SPDX-License-Identifier: MIT
#include "rules/coverage/point_ownership.h"

#include <fmt/format.h>
#include <cassert>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "exact/numeral.h"

namespace edgecase {
namespace {

// The larger of the centre's distances from the vertex along the two axes, raw.
std::int64_t chebyshev_distance(Point vertex, Point centre) {
  return std::max(std::abs(centre.x.raw() - vertex.x.raw()),
                  std::abs(centre.y.raw() - vertex.y.raw()));
}

}  // namespace

Point moved(Point vertex, PointOffset offset) {
  const Fixed eighth = Fixed::from_raw(Fixed::kOne / 8);
  if (offset == PointOffset::none) return vertex;
  return {vertex.x + eighth, vertex.y - eighth};
}

Rule point_offset_rule() {
  Rule rule;
  rule.id = RuleId::point_offset;
  rule.title = "A point's square is centred on its vertex";
  rule.spec = "14.4 (points)";
  rule.latitude = "none; ruling 6 judges the result";
  rule.standard = "none";
  rule.alternatives = alternatives_of<PointOffset>();
  return rule;
}

Rule point_clip_rule() {
  Rule rule;
  rule.id = RuleId::point_clip;
  rule.title = "A point is clipped by its vertex alone";
  rule.spec = "13.7 (primitive clipping)";
  rule.latitude =
      "OpenGL may draw a point whose vertex lies beyond the viewport's sides (ruling 42), OpenGL "
      "ES must (ruling 68); ruling 6 judges the result";
  rule.standard = "as-set";
  rule.alternatives = alternatives_of<PointClip>();
  return rule;
}

bool is_on_border(const ScenePrimitive& point) {
  const Vertex& vertex = *point.vertices[0];
  if (const auto& clip = vertex.clip)
    return std::max({std::fabs(clip->x), std::fabs(clip->y), std::fabs(clip->z)}) == clip->w;
  const Viewport& v = point.viewport;
  const auto is_end = [](Fixed at, int first, int length) {
    return at == Fixed::from_integer(first) || at == Fixed::from_integer(first + length);
  };
  return is_end(vertex.position.x, v.x, v.width) || is_end(vertex.position.y, v.y, v.height) ||
         std::abs(vertex.z.raw()) == Fixed::kOne;
}

std::span<const TieRule> point_tie_rules() {
  static const std::vector<TieRule> rules = [] {
    std::vector<TieRule> list;
    for (const TieRule& rule : all_tie_rules())
      if (rule.kind != TieRule::Kind::perturbed || rule.first_x != 0) list.push_back(rule);
    return list;
  }();
  return rules;
}

Rule point_ownership_rule() {
  return {
      RuleId::point_ownership,
      "A point covers the pixels whose centres lie in its square",
      "14.4 (points)",
      "a centre exactly on the boundary of the square may count or not; the vertex may be moved to "
      "the sub-pixel grid",
      "right-top",
      tie_alternatives(point_tie_rules(), Openness::open, Openness::open),
      {{6,
        "Points: the specification does not say whether the boundary of a point's square belongs "
        "to it. A pixel centre on the boundary, for some position of the vertex less than one "
        "step of 2^-b away (b as in ruling 4), may be covered or not. A size that the renderer's "
        "GL_POINT_SIZE_GRANULARITY does not include becomes the nearest supported one: one size "
        "for the whole point, no farther away than the nearest of those that it includes and 1, "
        "which must be supported. A multisampled point that is smaller than 1 may be as large as 1 "
        "(14.4). Sizes beyond the range that the renderer reports are not requested, so none is "
        "clamped."}}};
}

bool point_covers(const SizedPoint& point, Point sample, const TieRule& ties) {
  // All distances are doubled, since half a size need not be a whole raw unit.
  const std::int64_t size = point.size.raw();
  const std::int64_t dx = 2 * (sample.x.raw() - point.vertex.x.raw());
  const std::int64_t dy = 2 * (sample.y.raw() - point.vertex.y.raw());
  return ties.positive(size + dx, 1, 0) && ties.positive(size - dx, -1, 0) &&
         ties.positive(size + dy, 0, 1) && ties.positive(size - dy, 0, -1);
}

Explanation explain_point(const SizedPoint& point, Point sample, const TieRule& ties) {
  const bool centred = sample == pixel_centre(sample.x.floor(), sample.y.floor());
  const std::int64_t distance = chebyshev_distance(point.vertex, sample);
  const std::int64_t size = point.size.raw();
  const char* where = 2 * distance < size    ? "inside"
                      : 2 * distance == size ? "exactly on the boundary of"
                                             : "outside";
  const double half = point.size.to_double() / 2;
  Explanation result;
  result.text = fmt::format(
      "the {} {} lies {} the square of side {} round the point {} ({} from it along the axis where "
      "it is farther; {} is the boundary)",
      centred ? "pixel's centre" : "sample", format_point(sample), where, to_decimal(point.size),
      format_point(point.vertex), to_decimal(Fixed::from_raw(distance)), half);
  if (2 * distance == size)
    result.text += fmt::format("; the tie is decided by {}, so the {} counts as {}", ties.name,
                               centred ? "centre" : "sample",
                               point_covers(point, sample, ties) ? "inside" : "outside");
  const double px = point.vertex.x.to_double();
  const double py = point.vertex.y.to_double();
  result.figure.marks = {{MarkRole::region,
                          true,
                          {{px - half, py - half},
                           {px + half, py - half},
                           {px + half, py + half},
                           {px - half, py + half}},
                          ""},
                         sample_mark(sample)};
  return result;
}

bool point_possibly_covered(const SizedPoint& point, Point sample, Fixed reach) {
  return 2 * chebyshev_distance(point.vertex, sample) < point.size.raw() + 2 * reach.raw();
}

bool point_possibly_uncovered(const SizedPoint& point, Point sample, Fixed reach) {
  return 2 * chebyshev_distance(point.vertex, sample) > point.size.raw() - 2 * reach.raw();
}

HomogeneousPoint moved(const HomogeneousPoint& vertex, PointOffset offset) {
  return offset == PointOffset::none ? vertex : moved(vertex, 1, -1, 8);
}

bool point_covers(const HomogeneousSizedPoint& point, Point sample, const TieRule& ties) {
  // In units of 2^-17/w pixels: the size is at most 2^22 w, a distance 2^32 w, w 2^35.
  const HomogeneousPoint& vertex = point.vertex;
  assert(0 < vertex.w && vertex.w <= std::int64_t{1} << 35);
  assert(0 < point.size.raw() && point.size.raw() <= 1 << 22);
  const Int128 size = Int128{point.size.raw()} * vertex.w;
  const auto distance = [&](Fixed place, std::int64_t coordinate) {
    return 2 * (place.raw() * Int128{vertex.w} - Fixed::kOne * Int128{coordinate});
  };
  const Int128 dx = distance(sample.x, vertex.x);
  const Int128 dy = distance(sample.y, vertex.y);
  return ties.positive(size + dx, 1, 0) && ties.positive(size - dx, -1, 0) &&
         ties.positive(size + dy, 0, 1) && ties.positive(size - dy, 0, -1);
}

}  // namespace edgecase
