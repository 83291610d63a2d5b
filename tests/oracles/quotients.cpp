// SPDX-License-Identifier: MIT
#include "tests/oracles/quotients.h"

#include <algorithm>
#include <vector>

namespace edgecase::oracle {
namespace {

const Fraction kHalf(1, 2);

// What 0, 1 and 2 in a move stand for: nothing, e, e^2.
const Fraction& amount(int size) {
  using Integer = boost::multiprecision::cpp_int;
  static const Fraction amounts[] = {Fraction(0), Fraction(Integer(1), Integer(1) << 200),
                                     Fraction(Integer(1), Integer(1) << 400)};
  return amounts[size];
}

Fraction moved_by(const Fraction& value, int size) {
  return size < 0 ? Fraction(value - amount(-size)) : Fraction(value + amount(size));
}

Location moved(const Location& place, const Move& move) {
  return {moved_by(place.x, move.x), moved_by(place.y, move.y)};
}

Location moved_centre(int x, int y, const Move& move) {
  return moved({x + kHalf, y + kHalf}, move);
}

Fraction turn(const Location& a, const Location& b, const Location& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Does the set that a diamond is hold a point, seen from the diamond's centre?
bool holds(const Owned& owned, const Location& offset) {
  const int side = Fraction(abs(offset.x) + abs(offset.y) - kHalf).sign();
  if (side != 0) return side < 0;
  const int x = offset.x.sign();
  const int y = offset.y.sign();
  if (y == 0) return x < 0 ? owned.left : owned.right;
  if (x == 0) return y < 0 ? owned.bottom : owned.top;
  if (y < 0) return x < 0 ? owned.lower_left : owned.lower_right;
  return x < 0 ? owned.upper_left : owned.upper_right;
}

// 0, 1, where the segment crosses a line of the boundary, and halfway between neighbours.
std::vector<Fraction> parameters(const Location& a, const Location& run) {
  std::vector<Fraction> result{0, 1};
  for (int sx : {-1, 1})
    for (int sy : {-1, 1}) {
      const Fraction slope = run.x * sx + run.y * sy;
      if (slope == 0) continue;
      const Fraction t = (kHalf - a.x * sx - a.y * sy) / slope;
      if (t > 0 && t < 1) result.push_back(t);
    }
  std::sort(result.begin(), result.end());
  const std::size_t count = result.size();
  for (std::size_t i = 1; i < count; ++i) result.push_back((result[i - 1] + result[i]) / 2);
  return result;
}

}  // namespace

Location divided(const HomogeneousPoint& point) {
  return {Fraction(point.x) / point.w, Fraction(point.y) / point.w};
}

Location location(Point place) {
  return {Fraction(place.x.raw(), Fixed::kOne), Fraction(place.y.raw(), Fixed::kOne)};
}

bool triangle_has(const std::array<Location, 3>& t, int x, int y, const Ties& ties) {
  return triangle_has(t, Location{x + kHalf, y + kHalf}, ties);
}

bool point_has(const Location& vertex, const Fraction& size, int x, int y, const Ties& ties) {
  return point_has(vertex, size, Location{x + kHalf, y + kHalf}, ties);
}

bool triangle_has(const std::array<Location, 3>& t, const Location& at, const Ties& ties) {
  const Location sample = moved(at, ties.move);
  const int winding = turn(t[0], t[1], t[2]).sign();
  if (winding == 0) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if (!ties.accept(winding * turn(t[i], t[(i + 1) % 3], sample).sign())) return false;
  return true;
}

bool point_has(const Location& vertex, const Fraction& size, const Location& at, const Ties& ties) {
  const Location sample = moved(at, ties.move);
  return ties.accept(Fraction(size / 2 - abs(sample.x - vertex.x)).sign()) &&
         ties.accept(Fraction(size / 2 - abs(sample.y - vertex.y)).sign());
}

bool rectangle_has(const Location& a, const Location& b, const Fraction& width, const Location& at,
                   const Ties& ties) {
  const Location p = moved(at, ties.move);
  const Location run{b.x - a.x, b.y - a.y};
  const Fraction squared_length = run.x * run.x + run.y * run.y;
  if (squared_length == 0) return false;
  const Fraction along = (p.x - a.x) * run.x + (p.y - a.y) * run.y;
  const Fraction across = turn(a, b, p);
  // The distance from the line is across / length: compare squares.
  return ties.accept(along.sign()) && ties.accept(Fraction(squared_length - along).sign()) &&
         ties.accept(Fraction(width * width * squared_length - 4 * across * across).sign());
}

bool segment_has(const Location& a, const Location& b, int x, int y, const Boundary& boundary) {
  const Location centre = moved_centre(x, y, boundary.move);
  const Location run{b.x - a.x, b.y - a.y};
  const Owned& owned = abs(run.x) >= abs(run.y) ? boundary.x_major : boundary.y_major;
  if (holds(owned, {b.x - centre.x, b.y - centre.y})) return false;
  const Location from{a.x - centre.x, a.y - centre.y};
  for (const Fraction& t : parameters(from, run))
    if (holds(owned, {from.x + t * run.x, from.y + t * run.y})) return true;
  return false;
}

Fixed snapped(const Fraction& coordinate, int bits, std::string_view rounding) {
  using Integer = boost::multiprecision::cpp_int;
  const Fraction steps = coordinate * (1 << bits);
  Integer below = numerator(steps) / denominator(steps);
  if (below > steps) --below;
  const Fraction rest = steps - below;
  const bool up = (rounding == "half-up" && rest >= kHalf) ||
                  (rounding == "half-even" && (rest > kHalf || (rest == kHalf && below % 2 != 0)));
  if (up) ++below;
  return Fixed::from_raw(static_cast<std::int64_t>(below) * (Fixed::kOne >> bits));
}

}  // namespace edgecase::oracle
