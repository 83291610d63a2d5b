// SPDX-License-Identifier: MIT
#include "rules/coverage/clip_latitude.h"

#include <algorithm>
#include <cstdlib>

#include "exact/fixed.h"
#include "rules/coverage/clip_volume.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {
namespace {

// Twice the area, positive when counter-clockwise (y up).
Int128 doubled_area(const std::vector<Point>& polygon) {
  Int128 sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    sum += Int128{a.x.raw()} * b.y.raw() - Int128{b.x.raw()} * a.y.raw();
  }
  return sum;
}

std::vector<Point> counter_clockwise(std::vector<Point> polygon) {
  if (doubled_area(polygon) < 0) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

bool is_side(Fixed a, Fixed b, int low, int size) {
  return a == b && (a == Fixed::from_integer(low) || a == Fixed::from_integer(low + size));
}

bool is_on_viewport(Point a, Point b, const Viewport& viewport) {
  return is_side(a.x, b.x, viewport.x, viewport.width) ||
         is_side(a.y, b.y, viewport.y, viewport.height);
}

}  // namespace

// As triangle_possibly_covered: the union of all moved polygons is the sum of the polygon and an
// open square, from which an axis or an edge's normal separates what does not lie in it.
bool polygon_possibly_covered(const LoosePolygon& polygon, Point sample) {
  if (!is_in_viewport(homogeneous(sample), polygon.viewport)) return false;
  if (polygon.vertices.size() < 3) return false;
  const std::vector<Point> v = counter_clockwise(polygon.vertices);
  const auto [left, right] = std::ranges::minmax(v, {}, &Point::x);
  const auto [bottom, top] = std::ranges::minmax(v, {}, &Point::y);
  const Fixed reach = polygon.reach;
  if (sample.x <= left.x - reach || sample.x >= right.x + reach) return false;
  if (sample.y <= bottom.y - reach || sample.y >= top.y + reach) return false;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Point a = v[i], b = v[(i + 1) % v.size()];
    const std::int64_t dx = b.x.raw() - a.x.raw(), dy = b.y.raw() - a.y.raw();
    const Int128 aside = (Int128{std::abs(dx)} + std::abs(dy)) * reach.raw();
    const Int128 side =
        Int128{dx} * (sample.y.raw() - a.y.raw()) - Int128{dy} * (sample.x.raw() - a.x.raw());
    if (a != b && side <= -aside) return false;
  }
  return true;
}

bool polygon_possibly_uncovered(const LoosePolygon& polygon, Point sample) {
  if (!is_in_viewport(homogeneous(sample), polygon.viewport)) return true;
  if (polygon.vertices.size() < 3) return true;
  const std::vector<Point> v = counter_clockwise(polygon.vertices);
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Point a = v[i], b = v[(i + 1) % v.size()];
    if (a == b || is_on_viewport(a, b, polygon.viewport)) continue;
    if (!robustly_left(a, b, sample, polygon.reach)) return true;
  }
  return false;
}

}  // namespace edgecase
