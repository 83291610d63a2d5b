// SPDX-License-Identifier: MIT
#include "rules/values/interpolation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

#include "exact/rational.h"
#include "model/clipped_line.h"
#include "rules/coverage/clip_polygon.h"
#include "rules/coverage/homogeneous_line.h"
#include "rules/values/inexact_interpolation.h"
#include "rules/values/rational_interpolation.h"

namespace edgecase {

bool has_extent(const Interpolant& f) {
  if (f.kind == PrimitiveKind::triangle)
    return cross(f.positions[0], f.positions[1], f.positions[2]) != 0;
  return !same_point(f.positions[0], f.positions[1]);
}

namespace {

std::size_t count_of(const Interpolant& f) {
  return static_cast<std::size_t>(vertices_of(f.kind));
}

// True if these are the same number at all vertices.
bool is_one_number(const Interpolant& f, const std::array<Interval, 3>& numbers) {
  return std::all_of(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count_of(f)),
                     [&](Interval number) {
                       return number.low == numbers[0].low && number.high == numbers[0].high;
                     });
}

}  // namespace

bool is_constant(const Interpolant& f) {
  return is_one_number(f, f.values);
}

bool has_perspective(const Interpolant& f) {
  return f.perspective && !is_one_number(f, f.w);
}

bool is_linear(const Interpolant& f) {
  return is_constant(f) || !has_perspective(f);
}

bool is_x_major(const Interpolant& line) {
  return HomogeneousSegment{line.positions[0], line.positions[1]}.x_major();
}

bool goes_by_x(const Interpolant& line) {
  return is_x_major(line) == (line.line_parameter == LineParameter::major_axis);
}

bool may_swap_axes(const Interpolant& line, double reach) {
  const WindowPlaces v = places_of(line);
  const double dx = (v[1][0] - v[0][0]).magnitude();
  const double dy = (v[1][1] - v[0][1]).magnitude();
  return std::fabs(dx - dy) <= 4 * reach;
}

Interpolant over_w(Interpolant f) {
  for (std::size_t i = 0; i < count_of(f); ++i) f.values[i] = f.values[i] / f.w[i];
  f.perspective = false;
  return f;
}

Interpolant inverse_w(Interpolant f) {
  for (std::size_t i = 0; i < count_of(f); ++i) f.values[i] = Interval(1) / f.w[i];
  f.perspective = false;
  return f;
}

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

Interval weighted(const std::array<Interval, 3>& shares, const std::array<double, 3>& values) {
  // An attribute that is equal at all vertices is so everywhere.
  if (std::ranges::adjacent_find(values, std::not_equal_to()) == values.end()) return values[0];
  return shares[0] * values[0] + shares[1] * values[1] + shares[2] * values[2];
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
    std::array<Rational, 3> b;
    Rational sum = 0, depth = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational part =
          rational_of(cross(v[(i + 1) % 3], v[(i + 2) % 3], place)) / (area * place.w);
      plane.window_shares_[at][i] = interval_of(Rational(part * v[i].w));
      depth += part * triangle.z[i];
      b[i] = part * scale_of(triangle, i);
      sum += b[i];
    }
    // A position that rounding has moved off the triangle may lie behind the eye.
    if (sum <= 0) return std::nullopt;
    plane.w_[at] = interval_of(Rational(1 / sum));
    plane.depths_[at] = interval_of(depth);
    for (std::size_t i = 0; i < 3; ++i) plane.shares_[at][i] = interval_of(Rational(b[i] / sum));
  }
  return plane;
}

std::array<Interval, 3> ClippedPlane::smooth(const std::array<double, 3>& values) const {
  return {weighted(shares_[0], values), weighted(shares_[1], values), weighted(shares_[2], values)};
}

std::array<Interval, 3> ClippedPlane::noperspective(const std::array<double, 3>& values) const {
  return {weighted(window_shares_[0], values), weighted(window_shares_[1], values),
          weighted(window_shares_[2], values)};
}

// ------------------------------------------------------------------------------------------- lines

namespace {

std::array<Interval, 3> weighted(const std::array<std::array<Interval, 2>, 2>& shares,
                                 const std::array<double, 3>& values) {
  // An attribute that is equal at both vertices is so all the way.
  if (values[0] == values[1]) return {values[0], values[0], 0};
  const auto mean = [&](std::size_t end) {
    return shares[end][0] * values[0] + shares[end][1] * values[1];
  };
  return {mean(0), mean(1), 0};
}

}  // namespace

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
  return weighted(shares_, values);
}

std::array<Interval, 3> CutLine::noperspective(const std::array<double, 3>& values) const {
  return weighted(window_shares_, values);
}

}  // namespace edgecase
