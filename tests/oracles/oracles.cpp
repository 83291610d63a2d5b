// SPDX-License-Identifier: MIT
#include "tests/oracles/oracles.h"

#include <cstdint>

namespace edgecase::oracle {
namespace {

constexpr Int128 kPixel = Int128{1} << 32;
constexpr Int128 kHalf = kPixel / 2;

struct Position {
  Int128 x;
  Int128 y;
};

Int128 magnitude(Int128 value) {
  return value < 0 ? -value : value;
}

Position at(Eighths p) {
  return {p.x * (kPixel / 8), p.y * (kPixel / 8)};
}

Int128 step(int word) {
  const Int128 size = magnitude(word) == 1 ? (Int128{1} << 16) : Int128{1};
  return word < 0 ? -size : size;
}

Position moved(Position p, Move move) {
  return {p.x + step(move.x), p.y + step(move.y)};
}

Position centre(int x, int y) {
  return {x * kPixel + kHalf, y * kPixel + kHalf};
}

bool inside_diamond(Position p, Position c) {
  return magnitude(p.x - c.x) + magnitude(p.y - c.y) < kHalf;
}

// |x| + |y| along the segment is convex and piecewise linear: it is smallest at an end or where x
// or y changes sign. There, at t = -ax / dx, it is |ay dx - ax dy| / |dx|.
bool intersects_diamond(Position a, Position b, Position c) {
  if (inside_diamond(a, c) || inside_diamond(b, c)) return true;
  const Int128 ax = a.x - c.x, ay = a.y - c.y, bx = b.x - c.x, by = b.y - c.y;
  const Int128 dx = bx - ax, dy = by - ay;
  const Int128 turn = magnitude(ay * dx - ax * dy);
  const bool x_changes_sign = (ax < 0 && bx > 0) || (ax > 0 && bx < 0);
  const bool y_changes_sign = (ay < 0 && by > 0) || (ay > 0 && by < 0);
  return (x_changes_sign && turn < kHalf * magnitude(dx)) ||
         (y_changes_sign && turn < kHalf * magnitude(dy));
}

Int128 doubled_area(Position a, Position b, Position c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

bool line_produces(Eighths a, Eighths b, int x, int y, Move move) {
  // Moving both ends one way is moving the diamond the other.
  const Move back{-move.x, -move.y};
  const Position from = moved(at(a), back);
  const Position to = moved(at(b), back);
  const Position c = centre(x, y);
  return intersects_diamond(from, to, c) && !inside_diamond(to, c);
}

bool triangle_produces(const std::array<Eighths, 3>& triangle, int x, int y, Move move) {
  const Position a = at(triangle[0]), b = at(triangle[1]), c = at(triangle[2]);
  const Position p = moved(centre(x, y), move);
  const int whole = sign(doubled_area(a, b, c));
  return whole != 0 && sign(doubled_area(b, c, p)) == whole &&
         sign(doubled_area(c, a, p)) == whole && sign(doubled_area(a, b, p)) == whole;
}

bool point_produces(Eighths point, int x, int y, Move move) {
  const Position p = at(point);
  const Position c = moved(centre(x, y), move);
  return magnitude(c.x - p.x) < kHalf && magnitude(c.y - p.y) < kHalf;
}

}  // namespace edgecase::oracle
