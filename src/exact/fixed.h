// SPDX-License-Identifier: MIT
//
// Fixed: an exact dyadic number, a multiple of 2^-16.
//
// Every coordinate of a scene is one. A window coordinate lies in [-2^13, 2^13], so its raw integer
// lies in [-2^29, 2^29]; a difference of two fits in 31 bits, a product of two differences in 61,
// and the cross product that decides an edge in 62. All of this is plain int64 arithmetic without
// rounding. Larger results (the rotated diamond form, squared lengths) use Int128.
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>

namespace edgecase {

// 128-bit integers, for the few exact decisions whose products exceed 64 bits.
__extension__ using Int128 = __int128;

constexpr int sign(Int128 value) {
  return (value > 0) - (value < 0);
}

class Fixed {
 public:
  static constexpr int kFractionBits = 16;
  static constexpr std::int64_t kOne = std::int64_t{1} << kFractionBits;
  // Largest magnitude of a window coordinate, in pixels.
  static constexpr std::int64_t kMaxCoordinate = std::int64_t{1} << 13;

  constexpr Fixed() = default;

  // The number raw * 2^-16.
  static constexpr Fixed from_raw(std::int64_t raw) { return Fixed(raw); }
  static constexpr Fixed from_integer(std::int64_t value) { return Fixed(value * kOne); }
  // value + 1/2: the centre of pixel column or row `value`.
  static constexpr Fixed centre_of(std::int64_t value) { return Fixed(value * kOne + kOne / 2); }

  constexpr std::int64_t raw() const { return raw_; }
  // Exact: a raw value of a coordinate has at most 30 significant bits.
  constexpr double to_double() const { return static_cast<double>(raw_) / kOne; }

  // Largest integer not above the number.
  constexpr std::int64_t floor() const { return raw_ >> kFractionBits; }
  // Smallest integer not below the number.
  constexpr std::int64_t ceil() const { return -((-raw_) >> kFractionBits); }

  constexpr bool in_coordinate_range() const {
    return raw_ >= -kMaxCoordinate * kOne && raw_ <= kMaxCoordinate * kOne;
  }

  friend constexpr Fixed operator+(Fixed a, Fixed b) { return Fixed(a.raw_ + b.raw_); }
  friend constexpr Fixed operator-(Fixed a, Fixed b) { return Fixed(a.raw_ - b.raw_); }
  friend constexpr Fixed operator-(Fixed a) { return Fixed(-a.raw_); }
  friend constexpr auto operator<=>(Fixed, Fixed) = default;

 private:
  explicit constexpr Fixed(std::int64_t raw) : raw_(raw) {}
  std::int64_t raw_ = 0;
};

// A point of the window, in pixels, y up; pixel (i, j) has its centre at (i + 1/2, j + 1/2).
struct Point {
  Fixed x;
  Fixed y;
  friend constexpr bool operator==(Point, Point) = default;
};

constexpr Point pixel_centre(std::int64_t column, std::int64_t row) {
  return {Fixed::centre_of(column), Fixed::centre_of(row)};
}

// A difference of two points has components of at most 2^14 pixels, 2^30 raw; the two products
// below are at most 2^60 and their difference at most 2^61.
static_assert(2 * Fixed::kMaxCoordinate * Fixed::kOne <= (std::int64_t{1} << 30));

// (b - a) x (p - a) in units of 2^-32: positive when p lies to the left of a -> b (y up), zero on
// the line. a, b and p must be window coordinates.
constexpr std::int64_t cross(Point a, Point b, Point p) {
  return (b.x.raw() - a.x.raw()) * (p.y.raw() - a.y.raw()) -
         (b.y.raw() - a.y.raw()) * (p.x.raw() - a.x.raw());
}

// Pixels by column and row, and rectangles of them. Rows count from the bottom; sample positions
// within pixels play no role here.

struct PixelPosition {
  int x = 0;
  int y = 0;
  friend constexpr auto operator<=>(PixelPosition, PixelPosition) = default;
};

// Whole pixels, both ends inclusive; empty if a maximum is below its minimum.
struct PixelBounds {
  int x_min = 0;
  int y_min = 0;
  int x_max = -1;
  int y_max = -1;

  bool contains(PixelPosition p) const {
    return p.x >= x_min && p.x <= x_max && p.y >= y_min && p.y <= y_max;
  }
  PixelBounds grown(int by) const { return {x_min - by, y_min - by, x_max + by, y_max + by}; }
  friend constexpr bool operator==(const PixelBounds&, const PixelBounds&) = default;
};

// The intersection, which may be empty.
constexpr PixelBounds common_part(const PixelBounds& a, const PixelBounds& b) {
  return {std::max(a.x_min, b.x_min), std::max(a.y_min, b.y_min), std::min(a.x_max, b.x_max),
          std::min(a.y_max, b.y_max)};
}

}  // namespace edgecase
