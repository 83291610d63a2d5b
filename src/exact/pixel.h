// SPDX-License-Identifier: MIT
//
// Pixels by column and row, and rectangles of them. Rows count from the bottom; sample positions
// within pixels play no role here.
#pragma once

#include <algorithm>
#include <compare>

namespace edgecase {

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
