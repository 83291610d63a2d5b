// SPDX-License-Identifier: MIT
#include "tests/oracles/areas.h"

#include <algorithm>
#include <vector>

namespace edgecase::oracle {
namespace {

const Rational kHalf(1, 2);

Rational turn(const Spot& a, const Spot& b, const Spot& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Does the segment meet the open square of this half-width round the centre?
bool side_meets_square(const Spot& a, const Spot& b, const Spot& centre, const Rational& half) {
  const Spot d{b.x - a.x, b.y - a.y};
  std::vector<Rational> at{0, 1};
  const auto crossing = [&](const Rational& from, const Rational& by, const Rational& border) {
    if (by.sign() == 0) return;
    const Rational t = (border - from) / by;
    if (t > Rational(0) && t < Rational(1)) at.push_back(t);
  };
  for (int side : {-1, 1}) {
    crossing(a.x, d.x, centre.x + half * side);
    crossing(a.y, d.y, centre.y + half * side);
  }
  std::sort(at.begin(), at.end());
  const std::size_t count = at.size();
  for (std::size_t i = 1; i < count; ++i) at.push_back((at[i - 1] + at[i]) * kHalf);
  return std::any_of(at.begin(), at.end(), [&](const Rational& t) {
    return magnitude(a.x + t * d.x - centre.x) < half && magnitude(a.y + t * d.y - centre.y) < half;
  });
}

}  // namespace

int where_by_half_planes(const Corners& triangle, const Place& sample) {
  if (turn(triangle[0], triangle[1], triangle[2]).sign() == 0) return -1;
  int where = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Spot& p = triangle[i];
    const Spot& q = triangle[(i + 1) % 3];
    const Spot& third = triangle[(i + 2) % 3];
    const Rational a = p.y - q.y;
    const Rational b = q.x - p.x;
    const Rational c = -(a * p.x + b * p.y);
    const int inner = (a * third.x + b * third.y + c).sign();
    where = std::min(where, inner * (sample.x * a + sample.y * b + c).sign());
  }
  return where;
}

int where_by_cross_products(const Corners& triangle, const Place& sample) {
  if (turn(triangle[0], triangle[1], triangle[2]).sign() == 0) return -1;
  int least = 1;
  int most = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Spot& p = triangle[i];
    const Spot& q = triangle[(i + 1) % 3];
    const int side = ((sample.y - p.y) * (q.x - p.x) - (sample.x - p.x) * (q.y - p.y)).sign();
    least = std::min(least, side);
    most = std::max(most, side);
  }
  if (least < 0 && most > 0) return -1;
  return least == 0 || most == 0 ? 0 : 1;
}

int where_by_barycentric_signs(const Corners& triangle, const Place& sample) {
  // Rows (u, v | r): u s + v t = r, one for x and one for y.
  Rational ux = triangle[1].x - triangle[0].x, vx = triangle[2].x - triangle[0].x;
  Rational uy = triangle[1].y - triangle[0].y, vy = triangle[2].y - triangle[0].y;
  Nearby<2> rx = sample.x - triangle[0].x, ry = sample.y - triangle[0].y;
  if (ux.sign() == 0) {
    std::swap(ux, uy);
    std::swap(vx, vy);
    std::swap(rx, ry);
  }
  if (ux.sign() == 0) return -1;
  const Rational factor = uy / ux;
  const Rational pivot = vy - vx * factor;
  if (pivot.sign() == 0) return -1;
  const Nearby<2> t = (ry - rx * factor) * (Rational(1) / pivot);
  const Nearby<2> s = (rx - t * vx) * (Rational(1) / ux);
  return std::min({s.sign(), t.sign(), (Nearby<2>(1) - s - t).sign()});
}

int where_in_square(const Spot& point, const Rational& size, const Place& sample) {
  const Nearby<2> half = size * kHalf;
  return std::min((half - magnitude(sample.x - point.x)).sign(),
                  (half - magnitude(sample.y - point.y)).sign());
}

bool left_however_moved(const Spot& a, const Spot& b, const Spot& p, const Rational& step) {
  Nearby<1> reach(step);
  reach.c[1] = -step;
  for (int corner = 0; corner < 16; ++corner) {
    const auto put = [&](const Rational& from, int bit) {
      return Nearby<1>(from) + ((corner >> bit & 1) != 0 ? reach : -reach);
    };
    const auto ax = put(a.x, 0), ay = put(a.y, 1), bx = put(b.x, 2), by = put(b.y, 3);
    const auto side = product(bx - ax, Nearby<1>(p.y) - ay) - product(by - ay, Nearby<1>(p.x) - ax);
    if (side.sign() <= 0) return false;
  }
  return true;
}

bool coverable(const Corners& triangle, const Spot& sample, const Rational& step) {
  for (std::size_t i = 0; i < 3; ++i)
    if (side_meets_square(triangle[i], triangle[(i + 1) % 3], sample, step)) return true;
  return where_by_half_planes(triangle, moved(sample, {0, 0})) >= 0;
}

bool leavable(const Corners& triangle, const Spot& sample, const Rational& step) {
  auto [a, b, c] = triangle;
  const int way_round = turn(a, b, c).sign();
  if (way_round == 0) return true;
  if (way_round < 0) std::swap(b, c);
  return !left_however_moved(a, b, sample, step) || !left_however_moved(b, c, sample, step) ||
         !left_however_moved(c, a, sample, step);
}

Rational snapped(const Rational& value, int bits, std::string_view rounding) {
  const Rational step(1, Int128{1} << bits);
  const std::int64_t near = (value / step).floor();
  std::int64_t best = near - 2;
  for (std::int64_t k = near - 1; k <= near + 2; ++k) {
    const Rational at = Rational(k, 1) * step;
    const Rational old = Rational(best, 1) * step;
    if (rounding == "truncate") {
      if (at <= value) best = k;
      continue;
    }
    const Rational now = magnitude(value - at);
    const Rational before = magnitude(value - old);
    const bool wins_tie = rounding == "half-up" || k % 2 == 0;
    if (now < before || (now == before && wins_tie)) best = k;
  }
  return Rational(best, 1) * step;
}

}  // namespace edgecase::oracle
