// SPDX-License-Identifier: MIT
//
// The inexact and the permitted half of rules/values/interpolation.h: arithmetic in which every
// operation errs.
#include <cstddef>

#include "rules/values/inexact_place.h"
#include "rules/values/inexact_shares.h"
#include "rules/values/interpolation.h"
#include "rules/values/permitted_place.h"

namespace edgecase {
namespace {

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

Shares unmoved_shares(const Interpolant& f, const WindowPlace& p) {
  const WindowPlaces v = places_of(f);
  return f.kind == PrimitiveKind::line ? line_shares(f, v, p) : triangle_shares(v, p);
}

Interval unmoved_mean(const Interpolant& f, const WindowPlace& p) {
  return inexact_mean(f, unmoved_shares(f, p));
}

// -------------------------------------------------------------------------- inexact derivatives

// What a triangle's mean is divided by: the sum of the areas, each over its w.
Interval triangle_total(const Interpolant& f, const WindowPlaces& v, const WindowPlace& p) {
  const Inexact& op = kInexact;
  if (!has_perspective(f)) return area_of(op, v[1], v[2], v[0]);
  Interval total = 0;
  for (std::size_t i = 0; i < 3; ++i)
    total = op.add(total, op.divide(area_of(op, v[(i + 1) % 3], v[(i + 2) % 3], p), f.w[i]));
  return total;
}

// How fast each area grows along the axis: the opposite edge's run along the other one.
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

// How fast the shares of a line change along the axis.
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

// The sum of slope_i (a_i - a) / w_i, over the total. Any number will do for `value` where nothing
// is divided by w: the slopes sum to 0.
Interval inexact_slope(const Interpolant& f, const Shares& slopes, Interval value, Interval total) {
  const Inexact& op = kInexact;
  Interval sum = 0;
  const auto count = static_cast<std::size_t>(vertices_of(f.kind));
  for (std::size_t i = 0; i < count; ++i) {
    const Interval share = has_perspective(f) ? op.divide(slopes[i], f.w[i]) : slopes[i];
    sum = op.add(sum, op.multiply(share, op.subtract(f.values[i], value)));
  }
  return op.divide(sum, total);
}

Interval line_slope(const Interpolant& f, const WindowPlaces& v, const WindowPlace& p, Axis axis) {
  const Shares slopes = line_slopes(f, v, axis);
  if (!has_perspective(f)) return inexact_slope(f, slopes, f.values[0], 1);
  const SharesOverW shares = divided_by_w(f, line_shares(f, v, p));
  return inexact_slope(f, slopes, inexact_mean(f, shares), shares.total);
}

Interval triangle_slope(const Interpolant& f, const WindowPlaces& v, Axis axis, Interval value,
                        Interval total) {
  return inexact_slope(f, area_slopes(v, axis), has_perspective(f) ? value : f.values[0], total);
}

// A point's attributes are those of its vertex, whatever their qualifier (14.4); what is divided by
// w and multiplied again on the way may err twice.
Interval point_value(const Interpolant& f) {
  const Interval value = f.values[0];
  if (f.w[0].low == 1 && f.w[0].high == 1) return value;
  return kInexact.multiply(kInexact.divide(value, f.w[0]), f.w[0]);
}

}  // namespace

Interval interpolate_inexact(const Interpolant& f, Point sample) {
  return InexactPlace(sample).value(f);
}

Interval InexactPlace::value(const Interpolant& f) const {
  if (f.kind == PrimitiveKind::point) return point_value(f);
  if (!shares_) shares_ = unmoved_shares(f, place_of(sample_));
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
  const WindowPlaces& v = vertices_.grown();
  if (f.kind == PrimitiveKind::line) return line_slope(f, v, place_of(sample_), axis);
  return triangle_slope(f, v, axis, value, shares().total(f));
}

const MovedShares& PermittedPlace::shares() const {
  if (!shares_) shares_.emplace(vertices_, sample_);
  return *shares_;
}

Interval interpolate_permitted(const Interpolant& f, Point sample, double reach) {
  const MovedVertices vertices(f, reach);
  return PermittedPlace(vertices, sample).value(f);
}

Interval differentiate_inexact(const Interpolant& f, Point sample, Axis axis) {
  if (f.kind == PrimitiveKind::point) return 0;
  const WindowPlace p = place_of(sample);
  const WindowPlaces v = places_of(f);
  if (f.kind == PrimitiveKind::line) return line_slope(f, v, p, axis);
  return triangle_slope(f, v, axis, unmoved_mean(f, p), triangle_total(f, v, p));
}

Interval differentiate_permitted(const Interpolant& f, Point sample, Axis axis, double reach) {
  const MovedVertices vertices(f, reach);
  return PermittedPlace(vertices, sample).slope(f, axis);
}

}  // namespace edgecase
