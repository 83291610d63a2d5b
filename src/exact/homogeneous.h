// SPDX-License-Identifier: MIT
//
// HomogeneousPoint: an exact point of the window as a quotient of integers.
//
// A projected vertex lies on no grid: its window position is a quotient by its w. Which side of a
// line a sample lies on is still an integer question: a determinant with the three points as rows,
// without any division.
#pragma once

#include <cstdint>

#include "exact/fixed.h"

namespace edgecase {

// The point (x/w, y/w) in pixels, y up. 0 < w <= 2^32, |x| and |y| <= 2^14 w. A result of `moved`
// has a larger w, up to 2^35; predicates that accept it say so. For a vertex outside the clip
// volume w has either sign, or is 0, with |w| <= 2^32, and coordinates are at most 2^46; only
// `cross`, and predicates that say so, accept such a point.
struct HomogeneousPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t w = 1;
  // Equal in each number, not only as points.
  friend constexpr bool operator==(const HomogeneousPoint&, const HomogeneousPoint&) = default;
};

constexpr HomogeneousPoint homogeneous(Point point) {
  return {point.x.raw(), point.y.raw(), Fixed::kOne};
}

// The centre of pixel (column, row).
constexpr HomogeneousPoint homogeneous_centre(std::int64_t column, std::int64_t row) {
  return {2 * column + 1, 2 * row + 1, 2};
}

// Whether both are the same point, whatever their w.
constexpr bool same_point(const HomogeneousPoint& a, const HomogeneousPoint& b) {
  return Int128{a.x} * b.w == Int128{b.x} * a.w && Int128{a.y} * b.w == Int128{b.y} * a.w;
}

// The point (dx, dy)/parts pixels away, 1 <= parts <= 8, |dx| and |dy| <= 64. Its w is parts times
// as large.
constexpr HomogeneousPoint moved(const HomogeneousPoint& p, std::int64_t dx, std::int64_t dy,
                                 std::int64_t parts) {
  return {p.x * parts + dx * p.w, p.y * parts + dy * p.w, p.w * parts};
}

// The determinant of the rows a, b and p: (b - a) x (p - a) times the three w. Positive when p lies
// to the left of a -> b (y up), zero on the line. For three vertices a coordinate is at most 2^46
// and a w at most 2^32: a normal's component is at most 2^79, each of the three terms at most
// 2^125, and their sum less than 2^127. A sample (w = 2, coordinates of at most 2^15) leaves far
// more room.
constexpr Int128 cross(const HomogeneousPoint& a, const HomogeneousPoint& b,
                       const HomogeneousPoint& p) {
  const Int128 normal_x = Int128{a.y} * b.w - Int128{b.y} * a.w;
  const Int128 normal_y = Int128{b.x} * a.w - Int128{a.x} * b.w;
  return normal_x * p.x + normal_y * p.y + (Int128{a.x} * b.y - Int128{a.y} * b.x) * p.w;
}

// The nearest multiple of 2^-16; ties go to the right or up.
constexpr Point nearest_point(const HomogeneousPoint& p) {
  if (p.w == Fixed::kOne) return {Fixed::from_raw(p.x), Fixed::from_raw(p.y)};
  const auto nearest = [&](std::int64_t numerator) {
    const Int128 doubled = 2 * Int128{numerator} * Fixed::kOne + p.w;
    const Int128 divisor = 2 * Int128{p.w};
    const Int128 quotient = doubled / divisor;
    return Fixed::from_raw(
        static_cast<std::int64_t>(doubled % divisor < 0 ? quotient - 1 : quotient));
  };
  return {nearest(p.x), nearest(p.y)};
}

}  // namespace edgecase
