// SPDX-License-Identifier: MIT
#include "rules/samples/rounded_rectangle.h"

#include <algorithm>
#include <cstddef>

#include "exact/homogeneous.h"
#include "exact/rational.h"
#include "model/sampling.h"
#include "rules/coverage/line_areas.h"
#include "rules/coverage/window.h"

namespace edgecase {
namespace {

// 2 above / sqrt(below), rounded down.
struct DoubledQuotient {
  std::int64_t floor;
  bool is_whole;
};

// above: 0 to 2^53.
DoubledQuotient doubled_quotient(std::int64_t above, std::uint64_t below) {
  const Integer square = integer_of(Int128{4} * above * above);
  const Integer root = boost::multiprecision::sqrt(Integer(square / below));
  return {static_cast<std::int64_t>(root), root * root * below == square};
}

struct Squared {
  std::int64_t dx;
  std::int64_t dy;
  std::uint64_t length;  // squared
};

Squared squared(const Segment& s) {
  const std::int64_t dx = s.b.x.raw() - s.a.x.raw();
  const std::int64_t dy = s.b.y.raw() - s.a.y.raw();
  return {dx, dy,
          static_cast<std::uint64_t>(dx) * static_cast<std::uint64_t>(dx) +
              static_cast<std::uint64_t>(dy) * static_cast<std::uint64_t>(dy)};
}

// from + sign n, rounded.
Point moved_by_offset(Point from, const Squared& run, Fixed width, int sign, int bits,
                      HalfwayTo halfway) {
  // n is half of width (-dy, dx) over the length, so width times it over twice the length.
  const std::uint64_t below = 4 * run.length;
  const std::int64_t w = sign * width.raw();
  return {nearest_with_root(from.x.raw(), -w * run.dy, below, bits, halfway),
          nearest_with_root(from.y.raw(), w * run.dx, below, bits, halfway)};
}

}  // namespace

Fixed nearest_with_root(std::int64_t whole, std::int64_t above, std::uint64_t below, int bits,
                        HalfwayTo halfway) {
  // Rounding is symmetric about 0.
  if (above < 0) return -nearest_with_root(-whole, -above, below, bits, halfway);
  const std::int64_t step = grid_step(bits).raw();
  const DoubledQuotient doubled = doubled_quotient(above, below);
  // Twice the number plus half a step. The multiple at or below it is the nearest one or, of two,
  // the upper.
  const std::int64_t bound = 2 * whole + doubled.floor + step;
  std::int64_t k = bound >> (Fixed::kFractionBits + 1 - bits);
  const bool is_halfway = doubled.is_whole && 2 * k * step == bound;
  const bool goes_down = halfway == HalfwayTo::even ? k % 2 != 0 : k <= 0;
  if (is_halfway && goes_down) --k;
  return Fixed::from_raw(k * step);
}

std::array<Point, 4> rounded_corners(const Segment& segment, Fixed width,
                                     RectangleRounding rounding) {
  const Squared run = squared(segment);
  const auto corner = [&](Point end, int sign) -> Point {
    if (rounding == RectangleRounding::corners)
      return moved_by_offset(end, run, width, sign, 4, HalfwayTo::even);
    const auto nearest = [](Fixed value) {
      return nearest_with_root(value.raw(), 0, 1, 8, HalfwayTo::away_from_zero);
    };
    const Point n =
        moved_by_offset({Fixed(), Fixed()}, run, width, sign, 8, HalfwayTo::away_from_zero);
    return {nearest(end.x) + n.x, nearest(end.y) + n.y};
  };
  return {corner(segment.a, -1), corner(segment.b, -1), corner(segment.b, 1), corner(segment.a, 1)};
}

bool rounded_rectangle_covers(const std::array<Point, 4>& corners, Point sample,
                              const TieRule& ties) {
  Int128 area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point a = corners[i];
    const Point b = corners[(i + 1) % corners.size()];
    if (a == b) continue;  // made equal by rounding
    const Int128 dx = b.x.raw() - a.x.raw();
    const Int128 dy = b.y.raw() - a.y.raw();
    area += Int128{a.x.raw()} * b.y.raw() - Int128{b.x.raw()} * a.y.raw();
    if (!ties.positive(cross(a, b, sample), -dy, dx)) return false;
  }
  return area > 0;
}

bool crosses_borders(const std::array<Point, 4>& corners, const PixelBounds& bounds) {
  const auto holds_one = [&](Fixed Point::*axis, int first, int last) {
    const auto [least, most] =
        std::minmax({corners[0].*axis, corners[1].*axis, corners[2].*axis, corners[3].*axis});
    return std::max<std::int64_t>(least.ceil(), first) <=
           std::min<std::int64_t>(most.ceil() - 1, last);
  };
  return holds_one(&Point::x, bounds.x_min, bounds.x_max) &&
         holds_one(&Point::y, bounds.y_min, bounds.y_max);
}

std::vector<PixelPosition> rounded_rectangle_pixels(const Segment& segment, Fixed width,
                                                    RectangleRounding rounding,
                                                    const PixelBounds& bounds, Point within,
                                                    const TieRule& ties) {
  if (segment.a == segment.b) return {};
  const std::array<Point, 4> corners = rounded_corners(segment, width, rounding);
  // Rounding moves a corner by less than half a pixel, by which the search reaches farther.
  std::vector<PixelPosition> pixels = pixels_near_line(segment, width, bounds);
  std::erase_if(pixels, [&](PixelPosition pixel) {
    return !rounded_rectangle_covers(corners, place_in(pixel, within), ties);
  });
  return pixels;
}

}  // namespace edgecase
