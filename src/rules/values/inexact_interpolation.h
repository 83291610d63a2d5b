// SPDX-License-Identifier: MIT
//
// The inexact half of rules/values/interpolation.h: shares of a primitive's vertices and means by
// them, in arithmetic in which every operation errs.
#pragma once

#include <array>
#include <optional>

#include "exact/interval.h"
#include "rules/values/interpolation.h"

namespace edgecase {

// Arithmetic in which every result may be off by a relative amount.
struct Inexact {
  double relative;
  Interval add(Interval a, Interval b) const { return widened(a + b, relative); }
  Interval subtract(Interval a, Interval b) const { return widened(a - b, relative); }
  Interval multiply(Interval a, Interval b) const { return widened(a * b, relative); }
  Interval divide(Interval a, Interval b) const { return widened(a / b, relative); }
};

// The floating-point clause: relative error that one operation may have.
inline constexpr Inexact kInexact{1e-5};

// A position in the window, pixels: x and y, each a number except for the rounding of a quotient.
using WindowPlace = std::array<Interval, 2>;
using WindowPlaces = std::array<WindowPlace, 3>;
WindowPlace place_of(Point point);
WindowPlaces places_of(const Interpolant& f);

// One per vertex; their sum is about 1.
using Shares = std::array<Interval, 3>;

// Twice the area of a triangle, above 0 if a, b and p lie counter-clockwise.
Interval area_of(const Inexact& op, const WindowPlace& a, const WindowPlace& b,
                 const WindowPlace& p);
Shares triangle_shares(const WindowPlaces& v, const WindowPlace& p);
Shares line_shares(const Interpolant& f, const WindowPlaces& v, const WindowPlace& p);

// The shares, each divided by its w, and their sum.
struct SharesOverW {
  Shares shares;
  Interval total;
};
SharesOverW divided_by_w(const Interpolant& f, const Shares& shares);

// The mean by these shares: along a line without division by w, as equation 14.7 has it, or
// starting from the first vertex, as it can be read too.
Interval inexact_mean(const Interpolant& f, const Shares& shares);
// The same for an attribute with perspective.
Interval inexact_mean(const Interpolant& f, const SharesOverW& over_w);

// A point has the attributes of its vertex, whatever their qualifier (14.4); a value that is
// divided by w and multiplied again on the way may err twice.
Interval point_value(const Interpolant& f);

// The change of an attribute along an axis. For a triangle, `value` is the attribute's, used only
// with perspective, and `total` is the divisor of its mean.
Interval line_slope(const Interpolant& f, const WindowPlaces& v, const WindowPlace& p, Axis axis);
Interval triangle_slope(const Interpolant& f, const WindowPlaces& v, Axis axis, Interval value,
                        Interval total);

// The results of interpolate_inexact for several attributes of one primitive at one sample. The
// part that the attributes share is computed once.
class InexactPlace {
 public:
  explicit InexactPlace(Point sample) : sample_(sample) {}

  // Attributes have the same vertices and line parameter and, with perspective, the same w.
  Interval value(const Interpolant& f) const;

 private:
  Point sample_;
  // Computed on demand.
  mutable std::optional<Shares> shares_;
  mutable std::optional<SharesOverW> over_w_;
};

}  // namespace edgecase
