// SPDX-License-Identifier: MIT
#include "tests/oracles/diamonds.h"

#include <algorithm>
#include <vector>

#include "tests/oracles/ties.h"

namespace edgecase::oracle {
namespace {

const Rational kHalf(1, 2);

bool holds(const Owned& owned, const Place& offset) {
  const int side = (magnitude(offset.x) + magnitude(offset.y) - kHalf).sign();
  if (side != 0) return side < 0;
  const int x = offset.x.sign();
  const int y = offset.y.sign();
  if (y == 0) return x < 0 ? owned.left : owned.right;
  if (x == 0) return y < 0 ? owned.bottom : owned.top;
  if (y < 0) return x < 0 ? owned.lower_left : owned.lower_right;
  return x < 0 ? owned.upper_left : owned.upper_right;
}

const Owned& owned_for(const Line& line, const Boundary& boundary) {
  return is_x_major(line) ? boundary.x_major : boundary.y_major;
}

// Where a point lies, seen from the centre of a diamond that has been moved.
Place seen_from(const Spot& point, const Boundary& boundary, int x, int y) {
  const Place centre = moved(centre_of_pixel(x, y), boundary.move);
  return {Nearby<2>(point.x) - centre.x, Nearby<2>(point.y) - centre.y};
}

// The parameters that need looking at, 0 at the start to 1 at the end.
std::vector<Nearby<2>> parameters(const Place& a, const Rational& dx, const Rational& dy) {
  std::vector<Nearby<2>> result{Rational(0), Rational(1)};
  for (int sx : {-1, 1})
    for (int sy : {-1, 1}) {
      const Rational slope = dx * sx + dy * sy;
      if (slope.sign() == 0) continue;
      const auto t = (Nearby<2>(kHalf) - a.x * sx - a.y * sy) * (Rational(1) / slope);
      if (t.sign() > 0 && t < Nearby<2>(1)) result.push_back(t);
    }
  std::sort(result.begin(), result.end());
  const std::size_t count = result.size();
  for (std::size_t i = 1; i < count; ++i) result.push_back((result[i - 1] + result[i]) * kHalf);
  return result;
}

}  // namespace

bool is_x_major(const Line& line) {
  return magnitude(line.b.x - line.a.x) >= magnitude(line.b.y - line.a.y);
}

Boundary boundary_named(std::string_view name) {
  Boundary boundary;
  Owned owned;
  if (name == "direct3d") {
    // "The lower-left edge, lower-right edge, and bottom corner"; y-major: the right corner too.
    owned.lower_left = owned.lower_right = owned.bottom = true;
    boundary.x_major = owned;
    owned.right = true;
    boundary.y_major = owned;
    return boundary;
  }
  if (name == "scotty3d") {
    owned.lower_left = owned.lower_right = owned.upper_left = owned.upper_right = true;
    owned.left = owned.bottom = true;
  } else {
    const Ties ties = ties_named(name);
    boundary.move = ties.move;
    if (ties.closed) owned = {true, true, true, true, true, true, true, true};
  }
  boundary.x_major = boundary.y_major = owned;
  return boundary;
}

bool meets_diamond(const Line& line, const Boundary& boundary, int x, int y) {
  const Place a = seen_from(line.a, boundary, x, y);
  const Rational dx = line.b.x - line.a.x;
  const Rational dy = line.b.y - line.a.y;
  const Owned& owned = owned_for(line, boundary);
  for (const auto& t : parameters(a, dx, dy))
    if (holds(owned, {a.x + t * dx, a.y + t * dy})) return true;
  return false;
}

bool ends_in_diamond(const Line& line, const Boundary& boundary, int x, int y) {
  return holds(owned_for(line, boundary), seen_from(line.b, boundary, x, y));
}

bool exits_diamond(const Line& line, const Boundary& boundary, int x, int y) {
  return !ends_in_diamond(line, boundary, x, y) && meets_diamond(line, boundary, x, y);
}

}  // namespace edgecase::oracle
