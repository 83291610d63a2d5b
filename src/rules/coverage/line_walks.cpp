// SPDX-License-Identifier: MIT
#include "rules/coverage/line_walks.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "exact/fixed.h"
#include "rules/coverage/diamond_exit.h"

namespace edgecase {
namespace {

Int128 floor_divide(Int128 value, Int128 by) {
  const Int128 quotient = value / by;
  return quotient * by > value ? quotient - 1 : quotient;  // by > 0
}

// A segment turned so that its major axis is the first one.
struct Turned {
  bool x_major;
  Fixed a_major, a_minor, b_major, b_minor;

  explicit Turned(const Segment& s)
      : x_major(s.x_major()),
        a_major(x_major ? s.a.x : s.a.y),
        a_minor(x_major ? s.a.y : s.a.x),
        b_major(x_major ? s.b.x : s.b.y),
        b_minor(x_major ? s.b.y : s.b.x) {}

  PixelPosition pixel(std::int64_t major, std::int64_t minor) const {
    return {static_cast<int>(x_major ? major : minor), static_cast<int>(x_major ? minor : major)};
  }

  // The row that contains the line at the centre of a column; a pixel owns its lower border.
  std::int64_t row_at(std::int64_t column) const {
    Int128 run = b_major.raw() - a_major.raw();
    if (run == 0) return a_minor.floor();
    Int128 rise = b_minor.raw() - a_minor.raw();
    if (run < 0) {
      run = -run;
      rise = -rise;
    }
    const Int128 along = Fixed::centre_of(column).raw() - a_major.raw();
    const Int128 minor = a_minor.raw() * run + along * rise;  // times run
    return static_cast<std::int64_t>(floor_divide(minor, run * Fixed::kOne));
  }
};

// The first column whose centre is not below a coordinate.
std::int64_t first_centre_from(Fixed coordinate) {
  return Fixed::from_raw(coordinate.raw() - Fixed::kOne / 2).ceil();
}

// The last column whose centre is not above a coordinate.
std::int64_t last_centre_to(Fixed coordinate) {
  return Fixed::from_raw(coordinate.raw() - Fixed::kOne / 2).floor();
}

std::pair<std::int64_t, std::int64_t> columns_of(const Turned& t, WalkRange range) {
  const auto [low, high] = std::minmax({t.a_major, t.b_major});
  const Fixed ulp = Fixed::from_raw(1);
  switch (range) {
    case WalkRange::floor_to_floor:
    case WalkRange::ends_tested:
      return {low.floor(), high.floor()};
    case WalkRange::half_open_geometry:
      return {first_centre_from(low), last_centre_to(high - ulp)};
    case WalkRange::half_open_direction:
      if (t.a_major <= t.b_major)
        return {first_centre_from(t.a_major), last_centre_to(t.b_major - ulp)};
      return {first_centre_from(t.b_major + ulp), last_centre_to(t.a_major)};
  }
  return {0, -1};
}

std::int64_t to_integer(Fixed value, ToInteger rounding) {
  if (rounding == ToInteger::floor) return value.floor();
  return value.raw() / Fixed::kOne;
}

void keep(PixelPosition pixel, const PixelBounds& bounds, std::vector<PixelPosition>& pixels) {
  if (bounds.contains(pixel)) pixels.push_back(pixel);
}

}  // namespace

std::vector<PixelPosition> walk_pixels(const Segment& segment, const PixelBounds& bounds,
                                       WalkRange range, const DiamondBoundary& boundary) {
  const Turned t(segment);
  const auto [first, last] = columns_of(t, range);
  const std::int64_t low = t.x_major ? bounds.x_min : bounds.y_min;
  const std::int64_t high = t.x_major ? bounds.x_max : bounds.y_max;
  std::vector<PixelPosition> pixels;
  for (std::int64_t column = std::max(first, low); column <= std::min(last, high); ++column) {
    const PixelPosition pixel = t.pixel(column, t.row_at(column));
    const bool tested = range == WalkRange::ends_tested && (column == first || column == last);
    if (tested && !diamond_exit_covers(segment, pixel.x, pixel.y, boundary)) continue;
    keep(pixel, bounds, pixels);
  }
  return pixels;
}

std::vector<PixelPosition> bresenham_pixels(const Segment& segment, const PixelBounds& bounds,
                                            ToInteger rounding) {
  std::int64_t x = to_integer(segment.a.x, rounding);
  std::int64_t y = to_integer(segment.a.y, rounding);
  const std::int64_t dx = to_integer(segment.b.x, rounding) - x;
  const std::int64_t dy = to_integer(segment.b.y, rounding) - y;
  const bool x_major = std::abs(dx) > std::abs(dy);
  const std::int64_t major = x_major ? std::abs(dx) : std::abs(dy);
  const std::int64_t minor = x_major ? std::abs(dy) : std::abs(dx);
  const std::int64_t x_step = dx < 0 ? -1 : 1;
  const std::int64_t y_step = dy < 0 ? -1 : 1;

  std::vector<PixelPosition> pixels;
  std::int64_t error = 2 * minor - major;
  for (std::int64_t i = 0; i < major; ++i) {
    keep({static_cast<int>(x), static_cast<int>(y)}, bounds, pixels);
    (x_major ? x : y) += x_major ? x_step : y_step;
    if (error >= 0) {
      (x_major ? y : x) += x_major ? y_step : x_step;
      error -= 2 * major;
    }
    error += 2 * minor;
  }
  return pixels;
}

std::vector<PixelPosition> midpoint_pixels(const Segment& segment, const PixelBounds& bounds) {
  const auto centre = [](Point p) { return pixel_centre(p.x.floor(), p.y.floor()); };
  Segment whole{centre(segment.a), centre(segment.b)};
  if (Turned(whole).a_major > Turned(whole).b_major) std::swap(whole.a, whole.b);
  const Turned t(whole);
  const std::int64_t run = (t.b_major.raw() - t.a_major.raw()) / Fixed::kOne;
  const std::int64_t rise = std::abs(t.b_minor.raw() - t.a_minor.raw()) / Fixed::kOne;
  const std::int64_t step = t.b_minor < t.a_minor ? -1 : 1;

  std::vector<PixelPosition> pixels;
  std::int64_t minor = t.a_minor.floor();
  std::int64_t decision = 2 * rise - run;  // for the line at the first midpoint, half a step on
  for (std::int64_t i = 0; i <= run; ++i) {
    keep(t.pixel(t.a_major.floor() + i, minor), bounds, pixels);
    if (decision > 0) {
      minor += step;
      decision -= 2 * run;
    }
    decision += 2 * rise;
  }
  return pixels;
}

}  // namespace edgecase
