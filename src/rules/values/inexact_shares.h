// SPDX-License-Identifier: MIT
//
// Shares of a primitive's vertices and means by them, in arithmetic in which every operation errs:
// what the inexact and the permitted half of rules/values/interpolation.h are made of.
#pragma once

#include <array>

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

}  // namespace edgecase
