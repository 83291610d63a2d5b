// SPDX-License-Identifier: MIT
#include "rules/values/inexact_interpolation.h"

#include <algorithm>
#include <cstddef>

namespace edgecase {
namespace {

WindowPlace place_of(const HomogeneousPoint& p) {
  const auto w = static_cast<double>(p.w);
  return {Interval(static_cast<double>(p.x)) / w, Interval(static_cast<double>(p.y)) / w};
}

template <class Number>
Number weighted_sum(const Interpolant& f, const SharesOf<Number>& shares) {
  Number sum{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(vertices_of(f.kind)); ++i)
    sum = kInexact.add(sum, kInexact.multiply(shares[i], f.values[i]));
  return sum;
}

template <class Number>
Number mean_over_w(const Interpolant& f, const OverW<Number>& over_w) {
  return kInexact.divide(weighted_sum(f, over_w.shares), over_w.total);
}

}  // namespace

WindowPlace place_of(Point point) {
  return {point.x.to_double(), point.y.to_double()};
}

WindowPlaces places_of(const Interpolant& f) {
  return {place_of(f.positions[0]), place_of(f.positions[1]), place_of(f.positions[2])};
}

Interval inexact_mean(const Interpolant& f, const Shares& shares) {
  if (has_perspective(f)) return inexact_mean(f, divided_by_w(f, shares));
  if (f.kind != PrimitiveKind::line) return weighted_sum(f, shares);
  const Inexact& op = kInexact;
  const Interval mean =
      op.add(f.values[0], op.multiply(shares[1], op.subtract(f.values[1], f.values[0])));
  // In (1 - t) a + t b, three operations err by a part of the first product, and two by a part of
  // the second; by equation 14.6, if every w is the same, five more do: both sums have divisions by
  // w, and one is divided by the other. Interval shares would not sum to 1 there.
  const double more = f.perspective ? 5 : 0;
  const double error = op.relative * 1.001 *
                       ((3 + more) * (shares[0] * f.values[0]).magnitude() +
                        (2 + more) * (shares[1] * f.values[1]).magnitude());
  return mean + Interval(-error, error);
}

Interval inexact_mean(const Interpolant& f, const SharesOverW& over_w) {
  return mean_over_w(f, over_w);
}

namespace {

// As area_of() has it: each vertex is part of two areas.
Shares triangle_shares(const WindowPlaces& v, Interval area, const WindowPlace& p) {
  const Inexact& op = kInexact;
  WindowPlaces from_p;
  for (std::size_t i = 0; i < 3; ++i)
    from_p[i] = {op.subtract(v[i][0], p[0]), op.subtract(v[i][1], p[1])};
  const auto share = [&](const WindowPlace& a, const WindowPlace& b) {
    return op.divide(op.subtract(op.multiply(a[0], b[1]), op.multiply(a[1], b[0])), area);
  };
  return {share(from_p[1], from_p[2]), share(from_p[2], from_p[0]), share(from_p[0], from_p[1])};
}

Shares line_shares(const Interpolant& f, const WindowPlaces& v, const WindowPlace& p) {
  const Inexact& op = kInexact;
  const Interval dx = op.subtract(v[1][0], v[0][0]);
  const Interval dy = op.subtract(v[1][1], v[0][1]);
  Interval t;
  if (f.line_parameter != LineParameter::projection) {
    const std::size_t axis = goes_by_x(f) ? 0 : 1;
    t = op.divide(op.subtract(p[axis], v[0][axis]), axis == 0 ? dx : dy);
  } else {
    const Interval along = op.add(op.multiply(op.subtract(p[0], v[0][0]), dx),
                                  op.multiply(op.subtract(p[1], v[0][1]), dy));
    t = op.divide(along, op.add(op.multiply(dx, dx), op.multiply(dy, dy)));
  }
  return {op.subtract(1, t), t, 0};
}

// A point has the attributes of its vertex, whatever their qualifier (14.4); a value that is
// divided by w and multiplied again on the way may err twice.
Interval point_value(const Interpolant& f) {
  const Interval value = f.values[0];
  if (f.w[0].low == 1 && f.w[0].high == 1) return value;
  return kInexact.multiply(kInexact.divide(value, f.w[0]), f.w[0]);
}

Shares unmoved_shares(const Interpolant& f, const UnmovedVertices& vertices, const WindowPlace& p) {
  return f.kind == PrimitiveKind::line ? line_shares(f, vertices.places, p)
                                       : triangle_shares(vertices.places, vertices.area, p);
}

}  // namespace

UnmovedVertices::UnmovedVertices(const Interpolant& primitive)
    : places(places_of(primitive)), area(area_of(kInexact, places[1], places[2], places[0])) {}

Interval interpolate_inexact(const Interpolant& f, Point sample) {
  return InexactPlace(sample).value(f);
}

Interval InexactPlace::value(const Interpolant& f) const {
  if (f.kind == PrimitiveKind::point) return point_value(f);
  if (!shares_)
    shares_ = unmoved_shares(f, vertices_ != nullptr ? *vertices_ : UnmovedVertices(f),
                             place_of(sample_));
  if (!has_perspective(f)) return inexact_mean(f, *shares_);
  if (!over_w_) over_w_ = divided_by_w(f, *shares_);
  return inexact_mean(f, *over_w_);
}

Interval interpolate_inexact(const Interpolant& f, Point sample, Point w_place) {
  if (sample == w_place || !has_perspective(f)) return interpolate_inexact(f, sample);
  Interpolant above = over_w(f);
  for (Interval& value : above.values) value = kInexact.multiply(value, 1);
  const Interval w = kInexact.divide(1, interpolate_inexact(inverse_w(f), w_place));
  return kInexact.multiply(interpolate_inexact(above, sample), w);
}

// ------------------------------------------------------------------------------------- derivatives

namespace {

// The divisor of a triangle's mean: the sum of the areas, each over its w.
Interval triangle_total(const Interpolant& f, const WindowPlaces& v, const WindowPlace& p) {
  const Inexact& op = kInexact;
  if (!has_perspective(f)) return area_of(op, v[1], v[2], v[0]);
  Interval total = 0;
  for (std::size_t i = 0; i < 3; ++i)
    total = op.add(total, op.divide(area_of(op, v[(i + 1) % 3], v[(i + 2) % 3], p), f.w[i]));
  return total;
}

// The growth of each area along the axis: the opposite edge's run along the other axis.
Shares area_slopes(const WindowPlaces& v, Axis axis) {
  Shares slopes;
  for (std::size_t i = 0; i < 3; ++i) {
    const WindowPlace& from = v[(i + 1) % 3];
    const WindowPlace& to = v[(i + 2) % 3];
    slopes[i] =
        axis == Axis::x ? kInexact.subtract(from[1], to[1]) : kInexact.subtract(to[0], from[0]);
  }
  return slopes;
}

// The change of a line's shares along the axis.
Shares line_slopes(const Interpolant& f, const WindowPlaces& v, Axis axis) {
  const Inexact& op = kInexact;
  const Interval dx = op.subtract(v[1][0], v[0][0]);
  const Interval dy = op.subtract(v[1][1], v[0][1]);
  Interval slope;
  if (f.line_parameter != LineParameter::projection) {
    const bool by_x = goes_by_x(f);
    slope = by_x == (axis == Axis::x) ? op.divide(1, by_x ? dx : dy) : Interval(0);
  } else {
    slope = op.divide(axis == Axis::x ? dx : dy, op.add(op.multiply(dx, dx), op.multiply(dy, dy)));
  }
  return {op.subtract(0, slope), slope, 0};
}

Shares divided_slopes(const Interpolant& f, Shares slopes) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(vertices_of(f.kind)); ++i)
    slopes[i] = kInexact.divide(slopes[i], f.w[i]);
  return slopes;
}

// The sum of slope_i (a_i - a), over the total; with perspective, `slopes` are over w. Without it
// any number will do for `value`: the slopes sum to 0.
Interval inexact_slope(const Interpolant& f, const Shares& slopes, Interval value, Interval total) {
  const Inexact& op = kInexact;
  Interval sum = 0;
  const auto count = static_cast<std::size_t>(vertices_of(f.kind));
  for (std::size_t i = 0; i < count; ++i)
    sum = op.add(sum, op.multiply(slopes[i], op.subtract(f.values[i], value)));
  return op.divide(sum, total);
}

// The change of an attribute along an axis. For a triangle, `value` is the attribute's, used only
// with perspective, and `total` is the divisor of its mean.
Interval line_slope(const Interpolant& f, const WindowPlaces& v, const WindowPlace& p, Axis axis) {
  const Shares slopes = line_slopes(f, v, axis);
  if (!has_perspective(f)) return inexact_slope(f, slopes, f.values[0], 1);
  const SharesOverW shares = divided_by_w(f, line_shares(f, v, p));
  return inexact_slope(f, divided_slopes(f, slopes), inexact_mean(f, shares), shares.total);
}

Interval triangle_slope(const Interpolant& f, const Shares& slopes, Interval value,
                        Interval total) {
  return inexact_slope(f, slopes, has_perspective(f) ? value : f.values[0], total);
}

}  // namespace

Interval differentiate_inexact(const Interpolant& f, Point sample, Axis axis) {
  if (f.kind == PrimitiveKind::point) return 0;
  const WindowPlace p = place_of(sample);
  const UnmovedVertices vertices(f);
  const WindowPlaces& v = vertices.places;
  if (f.kind == PrimitiveKind::line) return line_slope(f, v, p, axis);
  const Shares slopes = area_slopes(v, axis);
  return triangle_slope(f, has_perspective(f) ? divided_slopes(f, slopes) : slopes,
                        inexact_mean(f, unmoved_shares(f, vertices, p)), triangle_total(f, v, p));
}

namespace {

// Without the clause: as wide as the rounding of doubles alone.
constexpr Inexact kExactly{0};

std::size_t next(std::size_t vertex) {
  return (vertex + 1) % 3;
}

}  // namespace

MovedVertices::MovedVertices(const Interpolant& primitive, double reach)
    : unmoved_(places_of(primitive)), grown_(unmoved_) {
  for (WindowPlace& place : grown_)
    for (Interval& axis : place) axis = axis + Interval(-reach, reach);
  if (primitive.kind == PrimitiveKind::triangle) move_triangle(reach);
}

void MovedVertices::move_triangle(double reach) {
  std::array<Moved, 3> moved;
  for (std::size_t vertex = 0; vertex < 3; ++vertex)
    for (std::size_t move = 0; move < 4; ++move)
      for (std::size_t axis = 0; axis < 2; ++axis)
        moved[vertex][move][axis] =
            unmoved_[vertex][axis] + ((move >> axis & 1U) != 0 ? reach : -reach);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t edge = 0; edge < kEdges; ++edge)
      for (std::size_t axis = 0; axis < 2; ++axis) {
        edges_[i].from[axis].set(edge, moved[next(i)][edge & 3][axis]);
        edges_[i].to[axis].set(edge, moved[next(next(i))][edge >> 2][axis]);
      }
  const auto area = [](const Inexact& op, const WindowPlace& a, const WindowPlace& b,
                       const WindowPlace& c) { return area_of(op, b, c, a); };
  area_ = area(kInexact, unmoved_[0], unmoved_[1], unmoved_[2]);
  is_above_zero_ = area(kExactly, unmoved_[0], unmoved_[1], unmoved_[2]).low > 0;
  for (std::size_t corner = 0; corner < kCorners; ++corner) {
    const WindowPlace& a = moved[0][move_of(corner, 0)];
    const WindowPlace& b = moved[1][move_of(corner, 1)];
    const WindowPlace& c = moved[2][move_of(corner, 2)];
    areas_.set(corner, area(kInexact, a, b, c));
    if ((area(kExactly, a, b, c).low > 0) != is_above_zero_) is_steady_ = false;
  }
  all_areas_ = hull(area_, hull_of(areas_));
}

const Shares& MovedVertices::slopes(const Interpolant& f, Axis axis) const {
  const std::size_t along = axis == Axis::x ? 0 : 1;
  std::optional<Shares>& plain = slopes_[along];
  if (!plain) plain = area_slopes(grown_, axis);
  if (!has_perspective(f)) return *plain;
  std::optional<Shares>& over_w = slopes_over_w_[along];
  if (!over_w) over_w = divided_slopes(f, *plain);
  return *over_w;
}

// ------------------------------------------------------------------------------------ moved shares

MovedShares::MovedShares(const MovedVertices& vertices, Point sample)
    : vertices_(vertices), sample_(place_of(sample)) {
  if (!vertices_.is_steady_) return;
  unmoved_ = triangle_shares(vertices_.unmoved_, vertices_.area_, sample_);
  areas_ = areas(kInexact);
  for (std::size_t i = 0; i < 3; ++i) shares_[i] = kInexact.divide(areas_[i], vertices_.areas_);
}

SharesOf<MovedShares::Corners> MovedShares::areas(const Inexact& op) const {
  SharesOf<Corners> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [from, to] = vertices_.edges_[i];
    const MovedVertices::Edges of_edges = area_of(op, from, to, sample_);
    for (std::size_t corner = 0; corner < MovedVertices::kCorners; ++corner) {
      const std::size_t edge = MovedVertices::move_of(corner, next(i)) |
                               MovedVertices::move_of(corner, next(next(i))) << 2;
      result[i].set(corner, of_edges[edge]);
    }
  }
  return result;
}

// False if a divisor may be 0 at a corner or change its sign between corners; then everything is
// permitted.
bool MovedShares::is_steady(const Interpolant& f) const {
  if (!vertices_.is_steady_) return false;
  if (!has_perspective(f)) return true;
  if (!total_keeps_sign_) total_keeps_sign_ = total_keeps_sign(f);
  return *total_keeps_sign_;
}

bool MovedShares::total_keeps_sign(const Interpolant& f) const {
  const auto total_of = [&](const auto& areas) {
    return areas[0] / f.w[0] + areas[1] / f.w[1] + areas[2] / f.w[2];
  };
  const WindowPlaces& v = vertices_.unmoved_;
  const Shares unmoved = {area_of(kExactly, v[1], v[2], sample_),
                          area_of(kExactly, v[2], v[0], sample_),
                          area_of(kExactly, v[0], v[1], sample_)};
  const bool is_above_zero = total_of(unmoved).low > 0;
  return std::ranges::all_of(total_of(areas(kExactly)).low,
                             [&](double low) { return (low > 0) == is_above_zero; });
}

Interval MovedShares::mean(const Interpolant& f) const {
  if (!is_steady(f)) return Interval::everything();
  if (!has_perspective(f))
    return hull(inexact_mean(f, unmoved_), hull_of(weighted_sum(f, shares_)));
  if (!over_w_) {
    unmoved_over_w_ = divided_by_w(f, unmoved_);
    over_w_ = divided_by_w(f, shares_);
  }
  return hull(inexact_mean(f, *unmoved_over_w_), hull_of(mean_over_w(f, *over_w_)));
}

Interval MovedShares::total(const Interpolant& f) const {
  if (!is_steady(f)) return Interval::everything();
  if (!has_perspective(f)) return vertices_.all_areas_;
  if (!total_over_w_) total_over_w_ = total_over_w(f);
  return *total_over_w_;
}

Interval MovedShares::total_over_w(const Interpolant& f) const {
  const WindowPlaces& v = vertices_.unmoved_;
  const Shares unmoved = {area_of(kInexact, v[1], v[2], sample_),
                          area_of(kInexact, v[2], v[0], sample_),
                          area_of(kInexact, v[0], v[1], sample_)};
  return hull(divided_by_w(f, unmoved).total, hull_of(divided_by_w(f, areas_).total));
}

// --------------------------------------------------------------------------------- permitted place

Interval PermittedPlace::value(const Interpolant& f) const {
  switch (f.kind) {
    case PrimitiveKind::point:
      return point_value(f);
    case PrimitiveKind::line:
      return inexact_mean(f, line_shares(f, vertices_.grown(), place_of(sample_)));
    case PrimitiveKind::triangle:
      return shares().mean(f);
  }
  return Interval::everything();
}

Interval PermittedPlace::slope(const Interpolant& f, Axis axis) const {
  return slope(f, axis, f.kind == PrimitiveKind::triangle && has_perspective(f) ? value(f) : 0);
}

std::array<Interval, 2> PermittedPlace::slopes(const Interpolant& f, Interval value) const {
  return {slope(f, Axis::x, value), slope(f, Axis::y, value)};
}

Interval PermittedPlace::slope(const Interpolant& f, Axis axis, Interval value) const {
  if (f.kind == PrimitiveKind::point) return 0;
  if (f.kind == PrimitiveKind::line)
    return line_slope(f, vertices_.grown(), place_of(sample_), axis);
  return triangle_slope(f, vertices_.slopes(f, axis), value, shares().total(f));
}

const MovedShares& PermittedPlace::shares() const {
  if (!shares_) shares_.emplace(vertices_, sample_);
  return *shares_;
}

Interval interpolate_permitted(const Interpolant& f, Point sample, double reach) {
  const MovedVertices vertices(f, reach);
  return PermittedPlace(vertices, sample).value(f);
}

Interval differentiate_permitted(const Interpolant& f, Point sample, Axis axis, double reach) {
  const MovedVertices vertices(f, reach);
  return PermittedPlace(vertices, sample).slope(f, axis);
}

}  // namespace edgecase
