// SPDX-License-Identifier: MIT
//
// Common parts of generated scenes.
#pragma once

#include <cstdint>
#include <span>

#include "model/scene.h"

namespace edgecase {

// A difference of two points in raw units of 2^-16 pixel.
struct RawVector {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

constexpr Point operator+(Point p, RawVector v) {
  return {Fixed::from_raw(p.x.raw() + v.x), Fixed::from_raw(p.y.raw() + v.y)};
}
constexpr Point operator-(Point p, RawVector v) {
  return p + RawVector{-v.x, -v.y};
}
constexpr RawVector operator-(Point p, Point q) {
  return {p.x.raw() - q.x.raw(), p.y.raw() - q.y.raw()};
}
constexpr RawVector operator*(std::int64_t n, RawVector v) {
  return {n * v.x, n * v.y};
}

// Twice the area between two vectors, positive if b lies to the left of a.
constexpr std::int64_t turn(RawVector a, RawVector b) {
  return a.x * b.y - a.y * b.x;
}

// A point in sixteenths of a pixel.
constexpr Point in_sixteenths(std::int64_t x, std::int64_t y) {
  return {Fixed::from_raw(x * Fixed::kOne / 16), Fixed::from_raw(y * Fixed::kOne / 16)};
}

// A square target without draws, with a viewport of the same size.
Scene empty_scene(Surface surface, int size);

// One draw; vertex v has colour v of 63 distinct colours without black.
Draw colored_draw(Primitive primitive, std::span<const Point> positions);

// The scene of that one draw.
Scene scene_of(Surface surface, int size, Primitive primitive, std::span<const Point> positions);

// Whether the point lies strictly inside a square target, or viewport.
bool strictly_inside(Point point, int size);

}  // namespace edgecase
