// SPDX-License-Identifier: MIT
#include "rules/values/inexact_interpolation.h"

#include <cstddef>

namespace edgecase {
namespace {

WindowPlace place_of(const HomogeneousPoint& p) {
  const auto w = static_cast<double>(p.w);
  return {Interval(static_cast<double>(p.x)) / w, Interval(static_cast<double>(p.y)) / w};
}

std::size_t count_of(const Interpolant& f) {
  return static_cast<std::size_t>(vertices_of(f.kind));
}

Interval weighted_sum(const Interpolant& f, const Shares& shares) {
  Interval sum = 0;
  for (std::size_t i = 0; i < count_of(f); ++i)
    sum = kInexact.add(sum, kInexact.multiply(shares[i], f.values[i]));
  return sum;
}

}  // namespace

WindowPlace place_of(Point point) {
  return {point.x.to_double(), point.y.to_double()};
}

WindowPlaces places_of(const Interpolant& f) {
  return {place_of(f.positions[0]), place_of(f.positions[1]), place_of(f.positions[2])};
}

Interval area_of(const Inexact& op, const WindowPlace& a, const WindowPlace& b,
                 const WindowPlace& p) {
  const Interval ax = op.subtract(a[0], p[0]);
  const Interval ay = op.subtract(a[1], p[1]);
  const Interval bx = op.subtract(b[0], p[0]);
  const Interval by = op.subtract(b[1], p[1]);
  return op.subtract(op.multiply(ax, by), op.multiply(ay, bx));
}

Shares triangle_shares(const WindowPlaces& v, const WindowPlace& p) {
  const Inexact& op = kInexact;
  const Interval area = area_of(op, v[1], v[2], v[0]);
  return {op.divide(area_of(op, v[1], v[2], p), area), op.divide(area_of(op, v[2], v[0], p), area),
          op.divide(area_of(op, v[0], v[1], p), area)};
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

SharesOverW divided_by_w(const Interpolant& f, const Shares& shares) {
  SharesOverW result;
  for (std::size_t i = 0; i < count_of(f); ++i) {
    result.shares[i] = kInexact.divide(shares[i], f.w[i]);
    result.total = kInexact.add(result.total, result.shares[i]);
  }
  return result;
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
  return kInexact.divide(weighted_sum(f, over_w.shares), over_w.total);
}

Interval point_value(const Interpolant& f) {
  const Interval value = f.values[0];
  if (f.w[0].low == 1 && f.w[0].high == 1) return value;
  return kInexact.multiply(kInexact.divide(value, f.w[0]), f.w[0]);
}

namespace {

Shares unmoved_shares(const Interpolant& f, const WindowPlace& p) {
  const WindowPlaces v = places_of(f);
  return f.kind == PrimitiveKind::line ? line_shares(f, v, p) : triangle_shares(v, p);
}

Interval unmoved_mean(const Interpolant& f, const WindowPlace& p) {
  return inexact_mean(f, unmoved_shares(f, p));
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

// The sum of slope_i (a_i - a) / w_i, over the total. Without division by w any number will do for
// `value`: the slopes sum to 0.
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

}  // namespace

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

Interval differentiate_inexact(const Interpolant& f, Point sample, Axis axis) {
  if (f.kind == PrimitiveKind::point) return 0;
  const WindowPlace p = place_of(sample);
  const WindowPlaces v = places_of(f);
  if (f.kind == PrimitiveKind::line) return line_slope(f, v, p, axis);
  return triangle_slope(f, v, axis, unmoved_mean(f, p), triangle_total(f, v, p));
}

}  // namespace edgecase
