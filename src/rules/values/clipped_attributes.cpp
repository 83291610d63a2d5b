// SPDX-License-Identifier: MIT
#include "rules/values/clipped_attributes.h"

#include <cstddef>
#include <vector>

#include "exact/rational.h"
#include "model/clipped_line.h"
#include "rules/coverage/clip_polygon.h"
#include "rules/coverage/homogeneous_line.h"
#include "rules/values/weighted_mean.h"

namespace edgecase {
namespace {

Int128 area_of(const std::array<HomogeneousPoint, 3>& p) {
  const Int128 area = cross(p[0], p[1], p[2]);
  return area < 0 ? -area : area;
}

// Three vertices of the polygon that are far from one line: those of the largest triangle.
std::optional<std::array<HomogeneousPoint, 3>> largest_triangle(
    const std::vector<ClipPolygonVertex>& polygon) {
  std::optional<std::array<HomogeneousPoint, 3>> largest;
  Int128 most = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    for (std::size_t j = i + 1; j < polygon.size(); ++j)
      for (std::size_t k = j + 1; k < polygon.size(); ++k) {
        const std::array<HomogeneousPoint, 3> p{homogeneous(polygon[i].position),
                                                homogeneous(polygon[j].position),
                                                homogeneous(polygon[k].position)};
        if (area_of(p) <= most) continue;
        most = area_of(p);
        largest = p;
      }
  return largest;
}

// The factor from a vertex' window coordinates times w to its position.
Rational scale_of(const ScenePrimitive& primitive, std::size_t i) {
  if (primitive.vertices[i]->clip) return Rational(2) / rational_of(primitive.units[i]);
  return Rational(Integer(primitive.positions[i].w)) / rational_of(primitive.vertices[i]->w);
}

// An attribute's mean by these shares. One that is equal at all `count` vertices is so everywhere.
Interval mean(const std::array<Interval, 3>& shares, const std::array<double, 3>& values,
              std::size_t count) {
  if (values[0] == values[1] && (count == 2 || values[0] == values[2])) return values[0];
  return weighted_sum(kOwnOperators, shares, values, count);
}

}  // namespace

std::optional<ClippedPlane> ClippedPlane::of(const ScenePrimitive& triangle) {
  const auto& v = triangle.positions;
  const Rational area = rational_of(cross(v[0], v[1], v[2]));
  if (area == 0) return std::nullopt;
  const auto places = largest_triangle(seen_polygon(triangle));
  if (!places) return std::nullopt;
  ClippedPlane plane;
  plane.positions_ = *places;
  for (std::size_t at = 0; at < 3; ++at) {
    const HomogeneousPoint& place = plane.positions_[at];
    const auto parts = by_opposite_edge(v, [&](const auto& a, const auto& b) {
      return Rational(rational_of(cross(a, b, place)) / (area * place.w));
    });
    std::array<Rational, 3> b;
    for (std::size_t i = 0; i < 3; ++i) {
      plane.window_shares_[at][i] = interval_of(Rational(parts[i] * v[i].w));
      b[i] = parts[i] * scale_of(triangle, i);
    }
    const Rational sum = add_weights(kOwnOperators, b[0], b, 1, 3);
    const Rational depth = weighted_sum(kOwnOperators, parts, triangle.z, 3);
    // A position that rounding has moved off the triangle may lie behind the eye.
    if (sum <= 0) return std::nullopt;
    plane.w_[at] = interval_of(Rational(1 / sum));
    plane.depths_[at] = interval_of(depth);
    for (std::size_t i = 0; i < 3; ++i) plane.shares_[at][i] = interval_of(Rational(b[i] / sum));
  }
  return plane;
}

std::array<Interval, 3> ClippedPlane::smooth(const std::array<double, 3>& values) const {
  return {mean(shares_[0], values, 3), mean(shares_[1], values, 3), mean(shares_[2], values, 3)};
}

std::array<Interval, 3> ClippedPlane::noperspective(const std::array<double, 3>& values) const {
  return {mean(window_shares_[0], values, 3), mean(window_shares_[1], values, 3),
          mean(window_shares_[2], values, 3)};
}

std::optional<CutLine> CutLine::of(const ScenePrimitive& line) {
  const RationalClip from = rational_clip(*line.vertices[0], line.viewport);
  const RationalClip to = rational_clip(*line.vertices[1], line.viewport);
  const auto part = visible_part(from, to, line.clips_sides);
  if (!part) return std::nullopt;
  CutLine result;
  const Rational* const parts[] = {&part->from, &part->to};
  for (std::size_t end = 0; end < 2; ++end) {
    const Rational& t = *parts[end];
    const RationalClip clip = between(from, to, t);
    result.w_[end] = interval_of(clip.w);
    result.depths_[end] = interval_of(Rational(clip.z / clip.w));
    result.shares_[end] = {interval_of(Rational(1 - t)), interval_of(t)};
    result.window_shares_[end] = {interval_of(Rational((1 - t) * from.w / clip.w)),
                                  interval_of(Rational(t * to.w / clip.w))};
  }
  return result;
}

std::array<Interval, 3> CutLine::smooth(const std::array<double, 3>& values) const {
  return {mean(shares_[0], values, 2), mean(shares_[1], values, 2), 0};
}

std::array<Interval, 3> CutLine::noperspective(const std::array<double, 3>& values) const {
  return {mean(window_shares_[0], values, 2), mean(window_shares_[1], values, 2), 0};
}

}  // namespace edgecase
