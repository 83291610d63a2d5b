// SPDX-License-Identifier: MIT
//
// Triangles, points and the freedom of moved vertices, literally.
//
// Courses teach three ways to ask whether a point lies in a triangle; here are all three, in exact
// arithmetic. Each answers 1 inside, 0 on the boundary, -1 outside; a moved sample is never on it.
#pragma once

#include <array>
#include <string_view>

#include "tests/oracles/nearby.h"

namespace edgecase::oracle {

using Corners = std::array<Spot, 3>;

// Three half planes a x + b y + c >= 0, each turned so that the third vertex lies in it.
int where_by_half_planes(const Corners& triangle, const Place& sample);
// The signs of the cross products of the edges, in turn, with the way to the sample: all alike.
int where_by_cross_products(const Corners& triangle, const Place& sample);
// p = a + s (b - a) + t (c - a), solved for s and t: both and 1 - s - t not negative.
int where_by_barycentric_signs(const Corners& triangle, const Place& sample);

// Of a square of side `size` round a point.
int where_in_square(const Spot& point, const Rational& size, const Place& sample);

// Does p lie strictly to the left of a -> b wherever a and b are moved by less than `step` in x and
// y? Moves by step (1 - e) for a small e stand for "less than".
bool left_however_moved(const Spot& a, const Spot& b, const Spot& p, const Rational& step);

// Can vertices moved by less than `step` put the sample into the triangle or on its boundary? That
// is so when the open square of half-width `step` round the sample meets the triangle: one of its
// sides does, or it lies in it whole.
bool coverable(const Corners& triangle, const Spot& sample, const Rational& step);

// Can such moves put the sample outside the triangle or on its boundary? Not if it stays strictly
// inside of all three sides.
bool leavable(const Corners& triangle, const Spot& sample, const Rational& step);

// The nearest grid value with this many fraction bits, by search; rounding is "half-even",
// "half-up" or "truncate" (the largest that is not above).
Rational snapped(const Rational& value, int bits, std::string_view rounding);

}  // namespace edgecase::oracle
