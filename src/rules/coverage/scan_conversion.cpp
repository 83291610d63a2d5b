// SPDX-License-Identifier: MIT
#include "rules/coverage/scan_conversion.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "exact/binary32.h"

namespace edgecase {
namespace {

struct ScanVertex {
  Binary32 x;
  Binary32 y;
};

// No constexpr: clang 14 has not made the template by which it is rounded yet.
const Binary32 kHalf = Binary32::from_fixed(Fixed::from_raw(Fixed::kOne / 2));

// The first row whose centre is not below y.
std::int64_t first_row(Binary32 y) {
  return (y - kHalf).ceil();
}

// An edge that is walked upward: at the centre of row first + k it crosses at x + k * slope. x has
// half a pixel added, so that dropping the fraction gives the first pixel beyond the edge.
struct ScanEdge {
  Binary32 x;
  Binary32 slope;
  std::int64_t rows = 0;

  ScanEdge(ScanVertex low, ScanVertex high) {
    const Binary32 rise = high.y - low.y;
    slope = rise.is_zero() ? Binary32() : (high.x - low.x) / rise;
    const Binary32 first = Binary32::from_integer(first_row(low.y));
    x = low.x + kHalf + (first - (low.y - kHalf)) * slope;
    rows = (high.y - kHalf - first).ceil();
  }
  std::int64_t crossing(std::int64_t row) const {
    return (x + Binary32::from_integer(row) * slope).truncate();
  }
  // Starts again, that many rows further up.
  void go_up(std::int64_t by) { x = x + Binary32::from_integer(by) * slope; }
};

// Draws `rows` rows from row `first`, from the left edge up to the right one, exclusive.
void fill(const ScanEdge& left, const ScanEdge& right, std::int64_t first, std::int64_t rows,
          const PixelBounds& bounds, std::vector<PixelPosition>& pixels) {
  const std::int64_t begin = std::max<std::int64_t>(first, bounds.y_min);
  const std::int64_t end = std::min<std::int64_t>(first + rows, bounds.y_max + 1);
  for (std::int64_t y = begin; y < end; ++y) {
    const auto from = std::max<std::int64_t>(left.crossing(y - first), bounds.x_min);
    const auto to = std::min<std::int64_t>(right.crossing(y - first), bounds.x_max + 1);
    for (std::int64_t x = from; x < to; ++x)
      pixels.push_back({static_cast<int>(x), static_cast<int>(y)});
  }
}

}  // namespace

std::vector<PixelPosition> scanned_triangle_pixels(const Triangle& triangle,
                                                   const PixelBounds& bounds) {
  std::array<ScanVertex, 3> v;
  for (std::size_t i = 0; i < 3; ++i)
    v[i] = {Binary32::from_fixed(triangle[i].x), Binary32::from_fixed(triangle[i].y)};
  std::stable_sort(v.begin(), v.end(), [](const ScanVertex& a, const ScanVertex& b) {
    return (a.y - b.y).is_negative();
  });
  const auto& [low, middle, high] = v;
  const Binary32 area =
      (high.x - low.x) * (middle.y - low.y) - (middle.x - low.x) * (high.y - low.y);
  // A triangle whose area rounds to zero is not drawn.
  if (area.is_zero()) return {};

  std::vector<PixelPosition> pixels;
  ScanEdge major(low, high);
  const ScanEdge bottom(low, middle);
  const ScanEdge top(middle, high);
  const bool major_left = area.is_negative();
  const auto fill_between = [&](const ScanEdge& other, std::int64_t first) {
    if (major_left)
      fill(major, other, first, other.rows, bounds, pixels);
    else
      fill(other, major, first, other.rows, bounds, pixels);
  };
  fill_between(bottom, first_row(low.y));
  major.go_up(bottom.rows);
  fill_between(top, first_row(low.y) + bottom.rows);
  return pixels;
}

}  // namespace edgecase
