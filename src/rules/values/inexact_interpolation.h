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

// In the window, pixels: x and y, each a number but for the rounding of a quotient.
using WindowPlace = std::array<Interval, 2>;
using WindowPlaces = std::array<WindowPlace, 3>;
WindowPlace place_of(Point point);
WindowPlaces places_of(const Interpolant& f);

// By vertex: they sum to about 1.
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

// The mean by these shares: along a line where nothing is divided by w, as equation 14.7 has it, or
// from the first vertex on, as that can be read too.
Interval inexact_mean(const Interpolant& f, const Shares& shares);
// The same of an attribute that has perspective.
Interval inexact_mean(const Interpolant& f, const SharesOverW& over_w);

// A point's attributes are those of its vertex, whatever their qualifier (14.4); what is divided by
// w and multiplied again on the way may err twice.
Interval point_value(const Interpolant& f);

// How fast an attribute changes along an axis. Of a triangle `value` is the attribute's, which
// counts where it has perspective, and `total` what its mean is divided by.
Interval line_slope(const Interpolant& f, const WindowPlaces& v, const WindowPlace& p, Axis axis);
Interval triangle_slope(const Interpolant& f, const WindowPlaces& v, Axis axis, Interval value,
                        Interval total);

// What interpolate_inexact yields for several attributes of one primitive at one sample. What the
// attributes share is worked out once.
class InexactPlace {
 public:
  explicit InexactPlace(Point sample) : sample_(sample) {}

  // Attributes have the same vertices and line parameter and, with perspective, the same w.
  Interval value(const Interpolant& f) const;

 private:
  Point sample_;
  // When they are first asked for.
  mutable std::optional<Shares> shares_;
  mutable std::optional<SharesOverW> over_w_;
};

}  // namespace edgecase
