// SPDX-License-Identifier: MIT
//
// The inexact half of rules/values/interpolation.h: arithmetic in which every operation errs.
#include <algorithm>
#include <cstddef>

#include "rules/values/interpolation.h"

namespace edgecase {
namespace {

using Weights = std::array<Interval, 3>;

std::size_t count_of(const Interpolant& f) {
  return static_cast<std::size_t>(vertices_of(f.kind));
}

using Position = std::array<Interval, 2>;
using Positions = std::array<Position, 3>;

// Arithmetic in which every result may be off by a relative amount.
struct Inexact {
  double relative;
  Interval add(Interval a, Interval b) const { return widened(a + b, relative); }
  Interval subtract(Interval a, Interval b) const { return widened(a - b, relative); }
  Interval multiply(Interval a, Interval b) const { return widened(a * b, relative); }
  Interval divide(Interval a, Interval b) const { return widened(a / b, relative); }
};

// The floating-point clause: relative error that one operation may have.
constexpr Inexact kInexact{1e-5};

Position position_of(const HomogeneousPoint& p) {
  const auto w = static_cast<double>(p.w);
  return {Interval(static_cast<double>(p.x)) / w, Interval(static_cast<double>(p.y)) / w};
}

Position position_of(Point p) {
  return {p.x.to_double(), p.y.to_double()};
}

Interval area_of(const Inexact& op, const Position& a, const Position& b, const Position& p) {
  const Interval ax = op.subtract(a[0], p[0]);
  const Interval ay = op.subtract(a[1], p[1]);
  const Interval bx = op.subtract(b[0], p[0]);
  const Interval by = op.subtract(b[1], p[1]);
  return op.subtract(op.multiply(ax, by), op.multiply(ay, bx));
}

// Shares of the vertices: they sum to about 1.
Weights triangle_shares(const Inexact& op, const Positions& v, const Position& p) {
  const Interval area = area_of(op, v[1], v[2], v[0]);
  return {op.divide(area_of(op, v[1], v[2], p), area), op.divide(area_of(op, v[2], v[0], p), area),
          op.divide(area_of(op, v[0], v[1], p), area)};
}

Weights line_shares(const Interpolant& f, const Positions& v, const Position& p) {
  const Inexact& op = kInexact;
  const Interval dx = op.subtract(v[1][0], v[0][0]);
  const Interval dy = op.subtract(v[1][1], v[0][1]);
  Interval t;
  if (f.line_parameter == LineParameter::major_axis) {
    const std::size_t major = is_x_major(f) ? 0 : 1;
    t = op.divide(op.subtract(p[major], v[0][major]), major == 0 ? dx : dy);
  } else {
    const Interval along = op.add(op.multiply(op.subtract(p[0], v[0][0]), dx),
                                  op.multiply(op.subtract(p[1], v[0][1]), dy));
    t = op.divide(along, op.add(op.multiply(dx, dx), op.multiply(dy, dy)));
  }
  return {op.subtract(1, t), t, 0};
}

// The sum of the shares, each divided by its w.
Interval inexact_total(const Interpolant& f, const Weights& shares) {
  Interval total = 0;
  for (std::size_t i = 0; i < count_of(f); ++i)
    total = kInexact.add(total, kInexact.divide(shares[i], f.w[i]));
  return total;
}

// The mean by these shares: along a line from the first vertex on, as the formula of 14.5.1 can be
// read too, where nothing is divided by w.
Interval inexact_mean(const Interpolant& f, const Weights& shares) {
  const Inexact& op = kInexact;
  if (!has_perspective(f) && f.kind == PrimitiveKind::line)
    return op.add(f.values[0], op.multiply(shares[1], op.subtract(f.values[1], f.values[0])));
  Interval sum = 0;
  for (std::size_t i = 0; i < count_of(f); ++i) {
    const Interval share = has_perspective(f) ? op.divide(shares[i], f.w[i]) : shares[i];
    sum = op.add(sum, op.multiply(share, f.values[i]));
  }
  return has_perspective(f) ? op.divide(sum, inexact_total(f, shares)) : sum;
}

Positions positions_of(const Interpolant& f) {
  return {position_of(f.positions[0]), position_of(f.positions[1]), position_of(f.positions[2])};
}

Positions grown(Positions v, double reach) {
  for (Position& position : v)
    for (Interval& axis : position) axis = axis + Interval(-reach, reach);
  return v;
}

// Is what the mean is divided by more than 0: the area, and with perspective the sum of the weights
// too? Both are linear in each coordinate of a vertex, so if they have one sign at all corners of
// its square of moves, they have it for all moves. What may be 0 at a corner is divided by there,
// and yields everything.
struct Signs {
  bool area;
  bool total;
  friend bool operator==(Signs, Signs) = default;
};

Signs signs_of(const Interpolant& f, const Positions& v, const Position& p) {
  const Inexact exactly{0};
  const bool area = area_of(exactly, v[1], v[2], v[0]).low > 0;
  if (!has_perspective(f)) return {area, area};
  const Interval total = area_of(exactly, v[1], v[2], p) / f.w[0] +
                         area_of(exactly, v[2], v[0], p) / f.w[1] +
                         area_of(exactly, v[0], v[1], p) / f.w[2];
  return {area, total.low > 0};
}

// With every vertex moved to one corner of its square of moves. False where a sign changes.
template <class Visit>
bool visit_corners(const Interpolant& f, const Position& p, double reach, Visit visit) {
  const Positions unmoved = positions_of(f);
  const Signs signs = signs_of(f, unmoved, p);
  for (unsigned corner = 0; corner < 64; ++corner) {
    Positions v = unmoved;
    for (unsigned axis = 0; axis < 6; ++axis) {
      Interval& moved = v[axis / 2][axis % 2];
      moved = moved + ((corner >> axis & 1u) != 0 ? reach : -reach);
    }
    if (signs_of(f, v, p) != signs) return false;
    visit(v);
  }
  return true;
}

Interval unmoved_mean(const Interpolant& f, const Position& p) {
  const Positions v = positions_of(f);
  return inexact_mean(
      f, f.kind == PrimitiveKind::line ? line_shares(f, v, p) : triangle_shares(kInexact, v, p));
}

// Numerator and denominator are linear in each coordinate, so the quotient is monotonic in each
// while the denominator keeps its sign, and the extremes lie at corners.
Interval mean_over_corners(const Interpolant& f, const Position& p, double reach) {
  Interval result = unmoved_mean(f, p);
  const bool steady = visit_corners(f, p, reach, [&](const Positions& v) {
    result = hull(result, inexact_mean(f, triangle_shares(kInexact, v, p)));
  });
  return steady ? result : Interval::everything();
}

// -------------------------------------------------------------------------- inexact derivatives

// What a triangle's mean is divided by: the sum of the areas, each over its w.
Interval triangle_total(const Interpolant& f, const Positions& v, const Position& p) {
  const Inexact& op = kInexact;
  if (!has_perspective(f)) return area_of(op, v[1], v[2], v[0]);
  Interval total = 0;
  for (std::size_t i = 0; i < 3; ++i)
    total = op.add(total, op.divide(area_of(op, v[(i + 1) % 3], v[(i + 2) % 3], p), f.w[i]));
  return total;
}

Interval total_over_corners(const Interpolant& f, const Position& p, double reach) {
  Interval result = triangle_total(f, positions_of(f), p);
  const bool steady = visit_corners(
      f, p, reach, [&](const Positions& v) { result = hull(result, triangle_total(f, v, p)); });
  return steady ? result : Interval::everything();
}

// How fast each area grows along the axis: the opposite edge's run along the other one.
Weights area_slopes(const Positions& v, Axis axis) {
  Weights slopes;
  for (std::size_t i = 0; i < 3; ++i) {
    const Position& from = v[(i + 1) % 3];
    const Position& to = v[(i + 2) % 3];
    slopes[i] =
        axis == Axis::x ? kInexact.subtract(from[1], to[1]) : kInexact.subtract(to[0], from[0]);
  }
  return slopes;
}

// How fast the shares of a line change along the axis.
Weights line_slopes(const Interpolant& f, const Positions& v, Axis axis) {
  const Inexact& op = kInexact;
  const Interval dx = op.subtract(v[1][0], v[0][0]);
  const Interval dy = op.subtract(v[1][1], v[0][1]);
  Interval slope;
  if (f.line_parameter == LineParameter::major_axis) {
    const bool x_major = is_x_major(f);
    slope = x_major == (axis == Axis::x) ? op.divide(1, x_major ? dx : dy) : Interval(0);
  } else {
    slope = op.divide(axis == Axis::x ? dx : dy, op.add(op.multiply(dx, dx), op.multiply(dy, dy)));
  }
  return {op.subtract(0, slope), slope, 0};
}

// The sum of slope_i (a_i - a) / w_i, over the total. Any number will do for `value` where nothing
// is divided by w: the slopes sum to 0.
Interval inexact_slope(const Interpolant& f, const Weights& slopes, Interval value,
                       Interval total) {
  const Inexact& op = kInexact;
  Interval sum = 0;
  for (std::size_t i = 0; i < count_of(f); ++i) {
    const Interval share = has_perspective(f) ? op.divide(slopes[i], f.w[i]) : slopes[i];
    sum = op.add(sum, op.multiply(share, op.subtract(f.values[i], value)));
  }
  return op.divide(sum, total);
}

Interval line_slope(const Interpolant& f, const Positions& v, const Position& p, Axis axis) {
  const Weights slopes = line_slopes(f, v, axis);
  if (!has_perspective(f)) return inexact_slope(f, slopes, f.values[0], 1);
  const Weights shares = line_shares(f, v, p);
  return inexact_slope(f, slopes, inexact_mean(f, shares), inexact_total(f, shares));
}

Interval triangle_slope(const Interpolant& f, const Positions& v, Axis axis, Interval value,
                        Interval total) {
  return inexact_slope(f, area_slopes(v, axis), has_perspective(f) ? value : f.values[0], total);
}

// A point's attributes are those of its vertex; what is divided by w and multiplied again on the
// way may err twice.
Interval point_value(const Interpolant& f) {
  const Interval value = f.values[0];
  if (!f.perspective || (f.w[0].low == 1 && f.w[0].high == 1)) return value;
  return kInexact.multiply(kInexact.divide(value, f.w[0]), f.w[0]);
}

}  // namespace

Interval interpolate_inexact(const Interpolant& f, Point sample) {
  if (f.kind == PrimitiveKind::point) return point_value(f);
  return unmoved_mean(f, position_of(sample));
}

Interval interpolate_inexact(const Interpolant& f, Point sample, Point w_place) {
  if (sample == w_place || !has_perspective(f)) return interpolate_inexact(f, sample);
  Interpolant above = over_w(f);
  for (Interval& value : above.values) value = kInexact.multiply(value, 1);
  const Interval w = kInexact.divide(1, interpolate_inexact(inverse_w(f), w_place));
  return kInexact.multiply(interpolate_inexact(above, sample), w);
}

Interval interpolate_permitted(const Interpolant& f, Point sample, double reach) {
  const Position p = position_of(sample);
  switch (f.kind) {
    case PrimitiveKind::point:
      return point_value(f);
    case PrimitiveKind::line:
      return inexact_mean(f, line_shares(f, grown(positions_of(f), reach), p));
    case PrimitiveKind::triangle:
      return mean_over_corners(f, p, reach);
  }
  return Interval::everything();
}

Interval differentiate_inexact(const Interpolant& f, Point sample, Axis axis) {
  if (f.kind == PrimitiveKind::point) return 0;
  const Position p = position_of(sample);
  const Positions v = positions_of(f);
  if (f.kind == PrimitiveKind::line) return line_slope(f, v, p, axis);
  return triangle_slope(f, v, axis, unmoved_mean(f, p), triangle_total(f, v, p));
}

Interval differentiate_permitted(const Interpolant& f, Point sample, Axis axis, double reach) {
  if (f.kind == PrimitiveKind::point) return 0;
  const Position p = position_of(sample);
  const Positions v = grown(positions_of(f), reach);
  if (f.kind == PrimitiveKind::line) return line_slope(f, v, p, axis);
  return triangle_slope(f, v, axis, mean_over_corners(f, p, reach),
                        total_over_corners(f, p, reach));
}

}  // namespace edgecase
