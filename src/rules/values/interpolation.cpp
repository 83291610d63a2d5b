// SPDX-License-Identifier: MIT
#include "rules/values/interpolation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

#include "exact/rational.h"
#include "model/clipped_line.h"
#include "rules/coverage/clip_volume.h"
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

using Weights = std::array<Interval, 3>;

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

// ------------------------------------------------------------------------------------------- exact

bool is_small(Int128 value) {
  constexpr Int128 kLimit = Int128{1} << 62;
  return -kLimit < value && value < kLimit;
}

// a b + c d. Factors below 2^62 are multiplied as integers, so nothing is lost if the two products
// nearly cancel.
Interval sum_of_products(Int128 a, Int128 b, Int128 c, Int128 d) {
  if (is_small(a) && is_small(b) && is_small(c) && is_small(d)) return interval_of(a * b + c * d);
  return interval_of(a) * interval_of(b) + interval_of(c) * interval_of(d);
}

// A point's distance from `from`, times both denominators.
struct Difference {
  Int128 x;
  Int128 y;
};

Difference difference(const HomogeneousPoint& to, const HomogeneousPoint& from) {
  return {Int128{to.x} * from.w - Int128{from.x} * to.w,
          Int128{to.y} * from.w - Int128{from.y} * to.w};
}

Int128 magnitude(Int128 value) {
  return value < 0 ? -value : value;
}

// With the projection: w_1 is (p - a).(b - a), times the three denominators, and the sum of both is
// |b - a|^2, times the same.
Weights line_weights(const Interpolant& f, const HomogeneousPoint& p) {
  const HomogeneousPoint& a = f.positions[0];
  const HomogeneousPoint& b = f.positions[1];
  const Difference run = difference(b, a);
  const Difference here = difference(p, a);
  const Difference rest = difference(b, p);
  if (f.line_parameter != LineParameter::projection) {
    const bool by_x = goes_by_x(f);
    const bool forward = (by_x ? run.x : run.y) > 0;
    const auto along = [&](const Difference& d) {
      return interval_of((by_x ? d.x : d.y) * (forward ? 1 : -1));
    };
    return {along(rest) * static_cast<double>(a.w), along(here) * static_cast<double>(b.w), 0};
  }
  return {sum_of_products(rest.x, run.x, rest.y, run.y) * static_cast<double>(a.w),
          sum_of_products(here.x, run.x, here.y, run.y) * static_cast<double>(b.w), 0};
}

// The determinant of the two other vertices and the sample is the area times all three denominators
// except the vertex's own.
Weights triangle_weights(const Interpolant& f, const HomogeneousPoint& p) {
  const auto& v = f.positions;
  const Int128 turn = cross(v[0], v[1], v[2]) < 0 ? -1 : 1;
  Weights result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] =
        interval_of(turn * cross(v[(i + 1) % 3], v[(i + 2) % 3], p)) * static_cast<double>(v[i].w);
  return result;
}

// The sum of the weights before division by w: it does not depend on the sample, and is known more
// precisely than by adding them.
Interval total_of(const Interpolant& f, const HomogeneousPoint& p) {
  const auto scale = static_cast<double>(p.w);
  if (f.kind == PrimitiveKind::triangle)
    return interval_of(magnitude(cross(f.positions[0], f.positions[1], f.positions[2]))) * scale;
  const Difference run = difference(f.positions[1], f.positions[0]);
  if (f.line_parameter != LineParameter::projection)
    return interval_of(magnitude(goes_by_x(f) ? run.x : run.y)) * scale;
  return sum_of_products(run.x, run.x, run.y, run.y) * scale;
}

// Positive inside the primitive.
Weights plain_weights(const Interpolant& f, const HomogeneousPoint& p) {
  return f.kind == PrimitiveKind::line ? line_weights(f, p) : triangle_weights(f, p);
}

Weights divided_by_w(Weights weights, const Interpolant& f) {
  for (std::size_t i = 0; i < count_of(f); ++i) weights[i] = weights[i] / f.w[i];
  return weights;
}

Weights exact_weights(const Interpolant& f, const HomogeneousPoint& p) {
  const Weights plain = plain_weights(f, p);
  return has_perspective(f) ? divided_by_w(plain, f) : plain;
}

// Numerator and denominator of the mean.
struct Mean {
  Interval sum;
  Interval total;
  Interval value() const { return sum / total; }
};

Mean mean_by(const Weights& weights, const Interpolant& f) {
  Mean mean{weights[0] * f.values[0], weights[0]};
  for (std::size_t i = 1; i < count_of(f); ++i) {
    mean.sum = mean.sum + weights[i] * f.values[i];
    mean.total = mean.total + weights[i];
  }
  return mean;
}

Mean mean_of(const Interpolant& f, const HomogeneousPoint& p) {
  Mean mean = mean_by(exact_weights(f, p), f);
  if (!has_perspective(f)) mean.total = total_of(f, p);
  return mean;
}

// Computed again without rounding, if the interval does not determine the nearest float32 number.
Interval settled(Interval value, const Interpolant& f, Point sample) {
  const Interval nearest = rounded_to_float(value);
  if (nearest.low == nearest.high) return value;
  const auto number = interpolate_rational(f, sample);
  return number ? interval_of(*number) : value;
}

// The sample's point, and the one a pixel further, over the same denominator.
HomogeneousPoint next_pixel(HomogeneousPoint p, Axis axis) {
  (axis == Axis::x ? p.x : p.y) += p.w;
  return p;
}

// Weights are linear in a homogeneous point: those of a direction are their change along it. They
// sum to 0, so the first vertex's value may be subtracted from all values.
Interval linear_slope(const Interpolant& f, Axis axis) {
  const Weights steps =
      plain_weights(f, axis == Axis::x ? HomogeneousPoint{1, 0, 0} : HomogeneousPoint{0, 1, 0});
  Interval slope = 0;
  for (std::size_t i = 1; i < count_of(f); ++i)
    slope = slope + steps[i] * (f.values[i] - f.values[0]);
  return slope / total_of(f, {0, 0, 1});
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

Interval interpolate_exact(const Interpolant& f, Point sample) {
  return ExactPlace(sample).value(f);
}

Interval ExactPlace::value(const Interpolant& f) const {
  if (f.kind == PrimitiveKind::point || is_constant(f)) return f.values[0];
  if (!has_extent(f)) return Interval::everything();
  Mean mean = mean_by(weights_of(f), f);
  if (!has_perspective(f)) mean.total = total_of(f);
  return settled(mean.value(), f, sample_);
}

bool ExactPlace::has_extent(const Interpolant& f) const {
  if (!has_extent_) has_extent_ = edgecase::has_extent(f);
  return *has_extent_;
}

const ExactPlace::Weights& ExactPlace::weights_of(const Interpolant& f) const {
  if (!plain_) plain_ = plain_weights(f, homogeneous(sample_));
  if (!has_perspective(f)) return *plain_;
  if (!over_w_) over_w_ = divided_by_w(*plain_, f);
  return *over_w_;
}

const Interval& ExactPlace::total_of(const Interpolant& f) const {
  if (!total_) total_ = edgecase::total_of(f, homogeneous(sample_));
  return *total_;
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

Interval interpolate_exact(const Interpolant& f, Point sample, Point w_place) {
  if (sample == w_place || !has_perspective(f)) return interpolate_exact(f, sample);
  return interpolate_exact(over_w(f), sample) / interpolate_exact(inverse_w(f), w_place);
}

// With N / D the mean, its derivative is (N' - (N / D) D') / D. Weights are linear in the sample,
// so N' and D' are differences over one pixel, exactly.
Interval differentiate_exact(const Interpolant& f, Point sample, Axis axis) {
  if (f.kind == PrimitiveKind::point || is_constant(f)) return 0;
  if (!has_extent(f)) return Interval::everything();
  if (is_linear(f)) return linear_slope(f, axis);
  const HomogeneousPoint p = homogeneous(sample);
  const Weights here = exact_weights(f, p);
  const Weights there = exact_weights(f, next_pixel(p, axis));
  const Mean mean = mean_of(f, p);
  const Interval value = mean.value();
  // N' - v D' as one sum over the vertices, so that values cancel and not products.
  Interval slope = 0;
  for (std::size_t i = 0; i < count_of(f); ++i)
    slope = slope + (there[i] - here[i]) * (f.values[i] - value);
  return slope / mean.total;
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
  const auto part = visible_part(from, to);
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
