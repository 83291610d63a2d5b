// SPDX-License-Identifier: MIT
//
// Edge functions of a triangle for incremental walks: a sample is inside if all three are >= 0.
//
// For each edge a -> b of a counter-clockwise triangle, rules/coverage/triangle_fill.h tests
// whether the cross product E at the sample is positive, or zero on an edge that owns its samples.
// Between pixels E changes by multiples of 2^16, since a sample's place within its pixel is
// constant and a pixel is 2^16 raw units wide. Two steps make this small and uniform:
//
//   owned or not   E > 0, or E = 0 and owned   <=>   E + owned - 1 >= 0         (integers)
//   fraction bits  E' >= 0                     <=>   floor(E' / 2^16) >= 0
//
// and floor((E' + k 2^16) / 2^16) = floor(E' / 2^16) + k. So the tie rule is one bit of a constant,
// and the function is exact with 16 bits less, whatever grid the vertices lie on:
//
//   e(x, y) = floor((E(0, 0) + owned - 1) / 2^16) + right x + up y
//
// Bounds, for vertices of at most 2^13 + 1 pixels (moving a sample to its pixel's centre moves the
// vertices by less than one): right and up are at most 2^30 + 2^17, E at a pixel of the window at
// most 2^61 + 2^50, and e at any pixel of the window less than 2^46.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <utility>

#include "exact/fixed.h"
#include "rules/coverage/tie_rule.h"

namespace edgecase {

// A point of the window in raw units of Fixed, y up; it takes half the memory of a Point.
struct RawPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
};
constexpr std::int64_t kLargestRaw = (Fixed::kMaxCoordinate + 1) * Fixed::kOne;
static_assert(kLargestRaw < std::int64_t{1} << 30);

constexpr bool is_raw_point(Point p) {
  const auto fits = [](Fixed value) {
    return value.raw() >= -kLargestRaw && value.raw() <= kLargestRaw;
  };
  return fits(p.x) && fits(p.y);
}
// The point must satisfy is_raw_point.
constexpr RawPoint raw_point(Point p) {
  assert(is_raw_point(p));
  return {static_cast<std::int32_t>(p.x.raw()), static_cast<std::int32_t>(p.y.raw())};
}

// A tie rule as a weighted sum of an edge function's gradient: the dominant direction weighs 2^32
// times as much as the other, whose part is less than 2^31. A `closed` rule consists of `always`
// alone, and an `open` rule is all zeros.
struct TieWeights {
  std::int64_t right = 0;
  std::int64_t up = 0;
  std::int64_t always = 0;

  // Whether a sample at which the function is zero is inside. The gradient's components are at most
  // 2^30 + 2^17 and the weights are 2^32 and 1, so the sum is less than 2^63.
  constexpr bool owns(std::int64_t gradient_right, std::int64_t gradient_up) const {
    return gradient_right * right + gradient_up * up + always > 0;
  }
};
static_assert((2 * kLargestRaw + 1) * ((std::int64_t{1} << 32) + 1) > 0, "no overflow");

constexpr TieWeights weights_of(const TieRule& ties) {
  constexpr std::int64_t kDominant = std::int64_t{1} << 32;
  if (ties.kind != TieRule::Kind::perturbed)
    return {0, 0, ties.kind == TieRule::Kind::closed ? 1 : 0};
  return {ties.first_x * kDominant + ties.second_x, ties.first_y * kDominant + ties.second_y, 0};
}

// The function e(x, y) above: its value at pixel (0, 0) and its growth per column and per row.
struct EdgeFunction {
  std::int64_t value = 0;
  std::int64_t right = 0;
  std::int64_t up = 0;
  constexpr std::int64_t at(std::int64_t x, std::int64_t y) const {
    return value + right * x + up * y;
  }
};

// A triangle of either winding.
class TriangleSetup {
 public:
  constexpr TriangleSetup(RawPoint a, RawPoint b, RawPoint c, const TieWeights& ties) {
    const std::int64_t area = (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
                              (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
    has_area_ = area != 0;
    if (area < 0) std::swap(b, c);
    edges_ = {corner_edge(a, b, ties), corner_edge(b, c, ties), corner_edge(c, a, ties)};
    low_ = {std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})};
    high_ = {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})};
  }

  constexpr bool has_area() const { return has_area_; }

  // The edge functions for samples at `place` in their pixels: raw, 0 to below 1 pixel.
  constexpr std::array<EdgeFunction, 3> edges_at(RawPoint place) const {
    std::array<EdgeFunction, 3> edges = edges_;
    for (EdgeFunction& edge : edges)
      edge.value = (edge.value + edge.right * place.x + edge.up * place.y) >> Fixed::kFractionBits;
    return edges;
  }

  // The columns and rows whose samples lie between the outermost vertices, inclusive; may be empty.
  // Outside of them every sample is strictly outside some edge, so there are no ties.
  constexpr PixelBounds box_at(RawPoint place) const {
    return {first_pixel(low_.x - place.x), first_pixel(low_.y - place.y),
            (high_.x - place.x) >> Fixed::kFractionBits,
            (high_.y - place.y) >> Fixed::kFractionBits};
  }

 private:
  // The function with all bits, at the lower left corner of pixel (0, 0).
  static constexpr EdgeFunction corner_edge(RawPoint a, RawPoint b, const TieWeights& ties) {
    const std::int64_t right = std::int64_t{a.y} - b.y;
    const std::int64_t up = std::int64_t{b.x} - a.x;
    return {(ties.owns(right, up) ? 0 : -1) - right * a.x - up * a.y, right, up};
  }
  static constexpr int first_pixel(std::int32_t raw) { return -(-raw >> Fixed::kFractionBits); }

  std::array<EdgeFunction, 3> edges_;
  RawPoint low_;
  RawPoint high_;
  bool has_area_ = false;
};

constexpr bool is_empty(const PixelBounds& box) {
  return box.x_min > box.x_max || box.y_min > box.y_max;
}
constexpr bool holds(const PixelBounds& outer, const PixelBounds& inner) {
  return inner.x_min >= outer.x_min && inner.x_max <= outer.x_max && inner.y_min >= outer.y_min &&
         inner.y_max <= outer.y_max;
}

constexpr RawPoint kCentrePlace{Fixed::kOne / 2, Fixed::kOne / 2};

}  // namespace edgecase
