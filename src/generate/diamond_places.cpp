// SPDX-License-Identifier: MIT
#include "generate/diamond_places.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "rules/coverage/diamond_exit.h"

namespace edgecase {
namespace {

constexpr std::int64_t kHalf = Fixed::kOne / 2;

// The quadrant of a slanting edge or of a place outside the diamond, as signs of x and y.
struct Quarter {
  std::int64_t x;
  std::int64_t y;
};
constexpr std::array<Quarter, 4> kQuarters{{{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};

DiamondPlace place_from(DiamondPlace first, std::int64_t dx, std::int64_t dy) {
  return static_cast<DiamondPlace>(static_cast<int>(first) + (dx > 0 ? 1 : 0) + (dy > 0 ? 2 : 0));
}

Point at_offset(std::int64_t dx, std::int64_t dy) {
  return {Fixed::from_raw(kHalf + dx), Fixed::from_raw(kHalf + dy)};
}

}  // namespace

LineDirection direction_of(const Segment& segment) {
  const std::int64_t dx = segment.b.x.raw() - segment.a.x.raw();
  const std::int64_t dy = segment.b.y.raw() - segment.a.y.raw();
  const std::int64_t wide = std::abs(dx);
  const std::int64_t high = std::abs(dy);
  // In the first quadrant: 0 on the x axis, 4 on the y axis.
  int place = 2;
  if (wide != high) place = wide > high ? (high == 0 ? 0 : 1) : (wide == 0 ? 4 : 3);
  if (dx < 0) place = 8 - place;
  if (dy < 0) place = (16 - place) % 16;
  return static_cast<LineDirection>(place);
}

std::optional<DiamondPlace> place_in_pixel(Point point, PixelPosition pixel) {
  const Point centre = pixel_centre(pixel.x, pixel.y);
  const std::int64_t dx = point.x.raw() - centre.x.raw();
  const std::int64_t dy = point.y.raw() - centre.y.raw();
  const std::int64_t distance = std::abs(dx) + std::abs(dy);
  if (distance < kHalf) return DiamondPlace::inside;
  if (distance == kHalf) {
    if (dy == 0) return dx < 0 ? DiamondPlace::left_corner : DiamondPlace::right_corner;
    if (dx == 0) return dy < 0 ? DiamondPlace::bottom_corner : DiamondPlace::top_corner;
    return place_from(DiamondPlace::lower_left_edge, dx, dy);
  }
  if (std::abs(dx) >= kHalf || std::abs(dy) >= kHalf) return std::nullopt;
  return place_from(DiamondPlace::lower_left_outside, dx, dy);
}

Point point_at(DiamondPlace place, std::int64_t along) {
  const int number = static_cast<int>(place);
  if (place == DiamondPlace::left_corner) return at_offset(-kHalf, 0);
  if (place == DiamondPlace::right_corner) return at_offset(kHalf, 0);
  if (place == DiamondPlace::bottom_corner) return at_offset(0, -kHalf);
  if (place == DiamondPlace::top_corner) return at_offset(0, kHalf);
  if (place == DiamondPlace::inside) return at_offset(along / 2, -(along / 4));
  const bool on_edge = number < static_cast<int>(DiamondPlace::inside);
  const int first =
      static_cast<int>(on_edge ? DiamondPlace::lower_left_edge : DiamondPlace::lower_left_outside);
  const Quarter quarter = kQuarters[static_cast<std::size_t>(number - first)];
  const std::int64_t dx = on_edge ? along : kHalf - along / 2;
  const std::int64_t dy = on_edge ? kHalf - along : dx;
  return at_offset(quarter.x * dx, quarter.y * dy);
}

Point random_point_at(DiamondPlace place, RandomSource& random, std::int64_t step) {
  // Halved twice, the result is still a multiple of `step`.
  const bool on_edge = place >= DiamondPlace::lower_left_edge && place < DiamondPlace::inside;
  const std::int64_t stride = on_edge ? step : 4 * step;
  return point_at(place, stride * random.between(1, (kHalf - 1) / stride));
}

RawVector random_along(RandomSource& random, LineDirection direction, std::int64_t length,
                       std::int64_t step) {
  const int number = static_cast<int>(direction);
  const std::int64_t longer = std::max(length / step, std::int64_t{2}) * step;
  const bool on_axis = number % 4 == 0;
  const bool diagonal = number % 4 == 2;
  const std::int64_t between = random.between(1, longer / step - 1) * step;
  const std::int64_t shorter = on_axis ? 0 : diagonal ? longer : between;
  const bool x_major = number % 8 <= 2 || number % 8 >= 6;
  const bool left = number > 4 && number < 12;
  const bool down = number > 8;
  const RawVector v = x_major ? RawVector{longer, shorter} : RawVector{shorter, longer};
  return {left ? -v.x : v.x, down ? -v.y : v.y};
}

bool is_tied(const Segment& segment, PixelPosition pixel) {
  static const DiamondBoundary& open = *find_diamond_boundary("open");
  static const DiamondBoundary& closed = *find_diamond_boundary("closed");
  return meets_diamond(segment, pixel.x, pixel.y, open) !=
             meets_diamond(segment, pixel.x, pixel.y, closed) ||
         ends_in_diamond(segment, pixel.x, pixel.y, open) !=
             ends_in_diamond(segment, pixel.x, pixel.y, closed);
}

}  // namespace edgecase
