// SPDX-License-Identifier: MIT
#include "rules/samples/half_planes.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace edgecase {
namespace {

// Where two boundaries cross: (x / w, y / w), w > 0. With the bounds of HalfPlane, x and y are at
// most 2^94 and w 2^63, so the sums below stay under 2^127.
struct Crossing {
  Int128 x = 0;
  Int128 y = 0;
  Int128 w = 0;
};

Crossing crossing(const HalfPlane& a, const HalfPlane& b) {
  const Int128 w = Int128{a.normal_x} * b.normal_y - Int128{a.normal_y} * b.normal_x;
  const Int128 x = a.limit * b.normal_y - b.limit * a.normal_y;
  const Int128 y = a.normal_x * b.limit - b.normal_x * a.limit;
  return w < 0 ? Crossing{-x, -y, -w} : Crossing{x, y, w};
}

bool holds(const HalfPlane& plane, const Crossing& point) {
  return plane.normal_x * point.x + plane.normal_y * point.y <= plane.limit * point.w;
}

std::int64_t floor_of(Int128 above, Int128 below) {
  const Int128 quotient = above / below;
  return static_cast<std::int64_t>(quotient * below > above ? quotient - 1 : quotient);
}

void add_around(std::vector<Point>& points, const Crossing& at) {
  const std::int64_t x[] = {floor_of(at.x, at.w), -floor_of(-at.x, at.w)};
  const std::int64_t y[] = {floor_of(at.y, at.w), -floor_of(-at.y, at.w)};
  for (const std::int64_t i : x)
    for (const std::int64_t j : y) points.push_back({Fixed::from_raw(i), Fixed::from_raw(j)});
}

}  // namespace

std::array<HalfPlane, 4> half_planes_of(PixelPosition pixel) {
  const std::int64_t x = pixel.x * Fixed::kOne;
  const std::int64_t y = pixel.y * Fixed::kOne;
  return {{{-1, 0, -x}, {1, 0, x + Fixed::kOne}, {0, -1, -y}, {0, 1, y + Fixed::kOne}}};
}

std::vector<Point> corners_of(std::span<const HalfPlane> planes) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      const Crossing at = crossing(planes[i], planes[j]);
      if (at.w == 0) continue;
      if (std::all_of(planes.begin(), planes.end(),
                      [&](const HalfPlane& plane) { return holds(plane, at); }))
        add_around(points, at);
    }
  const auto before = [](Point a, Point b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

}  // namespace edgecase
