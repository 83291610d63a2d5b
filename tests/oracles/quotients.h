// SPDX-License-Identifier: MIT
//
// The rules of coverage for vertices that are quotients, in fractions without a bound on their
// size.
//
// Everything is taken at its word: vertices are divided, the sample really moves by e and e^2 with
// e = 2^-200, and a pixel's diamond is a set of points of which a segment has one or has none. With
// all w at most 2^33 a function that a decision hangs on is at least 2^-120 where it is not zero,
// and its growth, too: so e is small enough.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>

#include "exact/homogeneous.h"
#include "tests/oracles/diamonds.h"
#include "tests/oracles/ties.h"

namespace edgecase::oracle {

using Fraction = boost::multiprecision::cpp_rational;

struct Location {
  Fraction x;
  Fraction y;
};

Location divided(const HomogeneousPoint& point);
Location location(Point place);

// GL 4.6 core, 14.6.1, 14.4 and 14.5.1. The point's size in pixels.
bool triangle_has(const std::array<Location, 3>& triangle, int x, int y, const Ties& ties);
bool point_has(const Location& vertex, const Fraction& size, int x, int y, const Ties& ties);
bool triangle_has(const std::array<Location, 3>& triangle, const Location& sample,
                  const Ties& ties);
bool point_has(const Location& vertex, const Fraction& size, const Location& sample,
               const Ties& ties);
// 14.5.4: the rectangle of a multisampled line, whose width is given in pixels.
bool rectangle_has(const Location& a, const Location& b, const Fraction& width,
                   const Location& sample, const Ties& ties);
bool segment_has(const Location& a, const Location& b, int x, int y, const Boundary& boundary);

// A coordinate on the grid of 2^-bits, by the name of the rounding, as multiple of 2^-16.
Fixed snapped(const Fraction& coordinate, int bits, std::string_view rounding);

}  // namespace edgecase::oracle
