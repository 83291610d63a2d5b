// SPDX-License-Identifier: MIT
//
// The inexact part of rules/values/interpolation.h: shares of a primitive's vertices and means by
// them, in arithmetic in which every operation errs.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "exact/interval.h"
#include "exact/interval_lanes.h"
#include "rules/values/interpolation.h"
#include "rules/values/weighted_mean.h"

namespace edgecase {

// Arithmetic in which every result may be off by a relative amount: of intervals, or of lanes of
// them with one interval or as many.
struct Inexact {
  double relative;
  Interval add(Interval a, Interval b) const { return widened(a + b, relative); }
  Interval subtract(Interval a, Interval b) const { return widened(a - b, relative); }
  Interval multiply(Interval a, Interval b) const { return widened(a * b, relative); }
  Interval divide(Interval a, Interval b) const { return widened(a / b, relative); }

  template <std::size_t N>
  IntervalLanes<N> add(const IntervalLanes<N>& a, const IntervalLanes<N>& b) const {
    return by_lane(LaneOperation::add, a, b, relative);
  }
  template <std::size_t N, class Operand>
  IntervalLanes<N> subtract(const IntervalLanes<N>& a, const Operand& b) const {
    return by_lane(LaneOperation::subtract, a, b, relative);
  }
  template <std::size_t N, class Operand>
  IntervalLanes<N> multiply(const IntervalLanes<N>& a, const Operand& b) const {
    return by_lane(LaneOperation::multiply, a, b, relative);
  }
  template <std::size_t N, class Operand>
  IntervalLanes<N> divide(const IntervalLanes<N>& a, const Operand& b) const {
    return by_lane(LaneOperation::divide, a, b, relative);
  }
};

// The floating-point clause: relative error that one operation may have.
inline constexpr Inexact kInexact{1e-5};

// A position in the window, pixels: x and y, each a number except for the rounding of a quotient.
using WindowPlace = std::array<Interval, 2>;
using WindowPlaces = std::array<WindowPlace, 3>;
WindowPlace place_of(Point point);
WindowPlaces places_of(const Interpolant& f);

// Weights of the vertices whose sum is about 1.
using Shares = WeightsOf<Interval>;

// a x b: above 0 if b lies counter-clockwise of a.
template <class Number>
Number cross(const Inexact& op, const std::array<Number, 2>& a, const std::array<Number, 2>& b) {
  return op.subtract(op.multiply(a[0], b[1]), op.multiply(a[1], b[0]));
}

// From p to a.
template <class Number>
std::array<Number, 2> difference(const Inexact& op, const std::array<Number, 2>& a,
                                 const WindowPlace& p) {
  return {op.subtract(a[0], p[0]), op.subtract(a[1], p[1])};
}

// Twice the area of a triangle, above 0 if a, b and p lie counter-clockwise.
template <class Number>
Number area_of(const Inexact& op, const std::array<Number, 2>& a, const std::array<Number, 2>& b,
               const WindowPlace& p) {
  return cross(op, difference(op, a, p), difference(op, b, p));
}

// Those of the triangles that p forms with each edge, by the vertex opposite to it.
Shares areas_at(const Inexact& op, const WindowPlaces& v, const WindowPlace& p);
// The same over the whole triangle's area.
Shares triangle_shares(const WindowPlaces& v, Interval area, const WindowPlace& p);

// The shares, each divided by its w, and their sum.
template <class Number>
struct OverW {
  WeightsOf<Number> shares;
  Number total;
};
using SharesOverW = OverW<Interval>;

template <class Number>
OverW<Number> divided_by_w(const Interpolant& f, const WeightsOf<Number>& shares) {
  const std::size_t count = count_of(f);
  OverW<Number> result{divided_by_w(kInexact, shares, f.w, count), {}};
  result.total = add_weights(kInexact, result.total, result.shares, 0, count);
  return result;
}

template <class Number>
Number inexact_sum(const Interpolant& f, const WeightsOf<Number>& shares) {
  return add_weighted(kInexact, Number{}, shares, f.values, 0, count_of(f));
}

// The mean of an attribute with perspective.
template <class Number>
Number inexact_mean(const Interpolant& f, const OverW<Number>& over_w) {
  return kInexact.divide(inexact_sum(f, over_w.shares), over_w.total);
}
// The mean by these shares: along a line without division by w, as equation 14.7 has it, or
// starting from the first vertex, as it can be read too.
Interval inexact_mean(const Interpolant& f, const Shares& shares);

// A point's attribute.
Interval inexact_at_point(const Interpolant& f);

// The growth of a triangle's areas per pixel along the axis: the opposite edges' run along the
// other axis.
Shares area_slopes(const WindowPlaces& v, Axis axis);
// The change of an attribute along an axis. For a triangle, `value` is the attribute's, used only
// with perspective, `slopes` are those of the areas, with perspective over w, and `total` is the
// divisor of its mean.
Interval line_slope(const Interpolant& f, const WindowPlaces& v, const WindowPlace& p, Axis axis);
Interval triangle_slope(const Interpolant& f, const Shares& slopes, Interval value, Interval total);

// What the samples of a primitive share.
struct UnmovedVertices {
  WindowPlaces places;
  Interval area;  // twice that of a triangle, in inexact arithmetic

  // `primitive`: one of its attributes, for its positions.
  explicit UnmovedVertices(const Interpolant& primitive);
};

// The results of interpolate_inexact for several attributes of one primitive at one sample. The
// part that the attributes share is computed once.
class InexactPlace {
 public:
  explicit InexactPlace(Point sample) : sample_(sample) {}
  // `vertices`, those of the attributes' primitive, must outlive this.
  InexactPlace(Point sample, const UnmovedVertices& vertices)
      : sample_(sample), vertices_(&vertices) {}

  // Attributes have the same vertices and line parameter and, with perspective, the same w.
  Interval value(const Interpolant& f) const;

 private:
  Point sample_;
  const UnmovedVertices* vertices_ = nullptr;
  // Computed on demand.
  mutable std::optional<Shares> shares_;
  mutable std::optional<SharesOverW> over_w_;
};

}  // namespace edgecase
