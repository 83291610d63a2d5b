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

}  // namespace

WindowPlace place_of(Point point) {
  return {point.x.to_double(), point.y.to_double()};
}

WindowPlaces places_of(const Interpolant& f) {
  return {place_of(f.positions[0]), place_of(f.positions[1]), place_of(f.positions[2])};
}

Interval inexact_mean(const Interpolant& f, const Shares& shares) {
  if (has_perspective(f)) return inexact_mean(f, divided_by_w(f, shares));
  if (f.kind != PrimitiveKind::line) return inexact_sum(f, shares);
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

Shares areas_at(const Inexact& op, const WindowPlaces& v, const WindowPlace& p) {
  const WindowPlaces from_p{difference(op, v[0], p), difference(op, v[1], p),
                            difference(op, v[2], p)};
  return by_opposite_edge(
      from_p, [&](const WindowPlace& a, const WindowPlace& b) { return cross(op, a, b); });
}

Shares triangle_shares(const WindowPlaces& v, Interval area, const WindowPlace& p) {
  Shares shares = areas_at(kInexact, v, p);
  for (Interval& share : shares) share = kInexact.divide(share, area);
  return shares;
}

// A point has the attributes of its vertex, whatever their qualifier (14.4); a value that is
// divided by w and multiplied again on the way may err twice.
Interval inexact_at_point(const Interpolant& f) {
  const Interval value = f.values[0];
  if (f.w[0].low == 1 && f.w[0].high == 1) return value;
  return kInexact.multiply(kInexact.divide(value, f.w[0]), f.w[0]);
}

namespace {

Shares unmoved_shares(const Interpolant& f, const UnmovedVertices& vertices, const WindowPlace& p) {
  return f.kind == PrimitiveKind::line ? line_weights(kInexact, f, vertices.places, p)
                                       : triangle_shares(vertices.places, vertices.area, p);
}

}  // namespace

UnmovedVertices::UnmovedVertices(const Interpolant& primitive)
    : places(places_of(primitive)), area(area_of(kInexact, places[1], places[2], places[0])) {}

Interval interpolate_inexact(const Interpolant& f, Point sample) {
  return InexactPlace(sample).value(f);
}

Interval InexactPlace::value(const Interpolant& f) const {
  if (f.kind == PrimitiveKind::point) return inexact_at_point(f);
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

Shares area_slopes(const WindowPlaces& v, Axis axis) {
  return by_opposite_edge(v, [&](const WindowPlace& from, const WindowPlace& to) {
    return axis == Axis::x ? kInexact.subtract(from[1], to[1]) : kInexact.subtract(to[0], from[0]);
  });
}

namespace {

// The divisor of a triangle's mean: the sum of the areas, each over its w.
Interval triangle_total(const Interpolant& f, const WindowPlaces& v, const WindowPlace& p) {
  if (!has_perspective(f)) return area_of(kInexact, v[1], v[2], v[0]);
  return divided_by_w(f, areas_at(kInexact, v, p)).total;
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

// With perspective, `slopes` are over w. Without it any number will do for `value`: the slopes sum
// to 0.
Interval inexact_slope(const Interpolant& f, const Shares& slopes, Interval value, Interval total) {
  return kInexact.divide(slope_sum(kInexact, slopes, f.values, value, 0, count_of(f)), total);
}

}  // namespace

Interval line_slope(const Interpolant& f, const WindowPlaces& v, const WindowPlace& p, Axis axis) {
  const Shares slopes = line_slopes(f, v, axis);
  if (!has_perspective(f)) return inexact_slope(f, slopes, f.values[0], 1);
  const SharesOverW shares = divided_by_w(f, line_weights(kInexact, f, v, p));
  return inexact_slope(f, divided_by_w(kInexact, slopes, f.w, 2), inexact_mean(f, shares),
                       shares.total);
}

Interval triangle_slope(const Interpolant& f, const Shares& slopes, Interval value,
                        Interval total) {
  return inexact_slope(f, slopes, has_perspective(f) ? value : f.values[0], total);
}

Interval differentiate_inexact(const Interpolant& f, Point sample, Axis axis) {
  if (f.kind == PrimitiveKind::point) return 0;
  const WindowPlace p = place_of(sample);
  const UnmovedVertices vertices(f);
  const WindowPlaces& v = vertices.places;
  if (f.kind == PrimitiveKind::line) return line_slope(f, v, p, axis);
  const Shares slopes = area_slopes(v, axis);
  return triangle_slope(f, has_perspective(f) ? divided_by_w(kInexact, slopes, f.w, 3) : slopes,
                        inexact_mean(f, unmoved_shares(f, vertices, p)), triangle_total(f, v, p));
}

}  // namespace edgecase
