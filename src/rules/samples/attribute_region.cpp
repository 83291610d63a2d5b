// SPDX-License-Identifier: MIT
//
// permitted_locations: the part of a pixel that a primitive covers, for all moves of its vertices.
#include "rules/samples/attribute_location.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

#include "rules/coverage/segment.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {
namespace {

using HalfPlanes = std::vector<HalfPlane>;

std::int64_t raw_length(Fixed from, Fixed to) {
  return std::abs(to.raw() - from.raw());
}

// A box round points, grown by a margin on each side.
void add_box(HalfPlanes& planes, std::span<const Point> points, std::int64_t margin) {
  const auto [left, right] =
      std::minmax_element(points.begin(), points.end(), [](Point a, Point b) { return a.x < b.x; });
  const auto [bottom, top] =
      std::minmax_element(points.begin(), points.end(), [](Point a, Point b) { return a.y < b.y; });
  planes.push_back({-1, 0, margin - left->x.raw()});
  planes.push_back({1, 0, right->x.raw() + margin});
  planes.push_back({0, -1, margin - bottom->y.raw()});
  planes.push_back({0, 1, top->y.raw() + margin});
}

// All moved triangles lie in the sum of the triangle and a square (triangle_fill.cpp).
void add_triangle(HalfPlanes& planes, const Triangle& given, std::int64_t reach) {
  add_box(planes, given, reach);
  if (doubled_area(given) == 0) return;
  const Triangle t = counter_clockwise(given);
  for (std::size_t i = 0; i < 3; ++i) {
    const Point a = t[i];
    const Point b = t[(i + 1) % 3];
    const std::int64_t dx = b.x.raw() - a.x.raw();
    const std::int64_t dy = b.y.raw() - a.y.raw();
    const Int128 at_a = Int128{dy} * a.x.raw() - Int128{dx} * a.y.raw();
    planes.push_back({dy, -dx, at_a + Int128{std::abs(dx) + std::abs(dy)} * reach});
  }
}

// The whole number at or above the square root; the number is at most 2^62.
std::int64_t root_above(Int128 value) {
  auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(value)));
  while (Int128{root} * root < value) ++root;
  return root;
}

// How much a product of the segment and the way from an end to a point of the pixel can change as
// the ends move: the end itself moves, and the segment changes by twice as much.
Int128 change_of_products(const Segment& s, Point end, PixelPosition pixel, std::int64_t reach) {
  const auto farthest = [&](Fixed from, int column) {
    return std::max(raw_length(from, Fixed::from_integer(column)),
                    raw_length(from, Fixed::from_integer(column + 1)));
  };
  const std::int64_t way = farthest(end.x, pixel.x) + farthest(end.y, pixel.y) + 2 * reach;
  const std::int64_t run = raw_length(s.a.x, s.b.x) + raw_length(s.a.y, s.b.y);
  return Int128{way} * 2 * reach + Int128{run} * reach;
}

void add_rectangle(HalfPlanes& planes, const Segment& s, Fixed width, PixelPosition pixel,
                   std::int64_t reach) {
  const std::int64_t dx = s.b.x.raw() - s.a.x.raw();
  const std::int64_t dy = s.b.y.raw() - s.a.y.raw();
  const auto along = [&](Point p) { return Int128{dx} * p.x.raw() + Int128{dy} * p.y.raw(); };
  planes.push_back({-dx, -dy, change_of_products(s, s.a, pixel, reach) - along(s.a)});
  planes.push_back({dx, dy, along(s.b) + change_of_products(s, s.b, pixel, reach)});
  // Half the width times the length, for a segment whose ends move apart or together.
  const std::int64_t length = root_above(Int128{dx} * dx + Int128{dy} * dy) + 3 * reach;
  const Int128 aside =
      (Int128{width.raw()} * length + 1) / 2 + change_of_products(s, s.a, pixel, reach);
  const Int128 at_a = Int128{dy} * s.a.x.raw() - Int128{dx} * s.a.y.raw();
  planes.push_back({dy, -dx, aside + at_a});
  planes.push_back({-dy, dx, aside - at_a});
}

std::vector<Point> corners_of_pixel(PixelPosition pixel) {
  return corners_of(half_planes_of(pixel));
}

std::vector<Point> shared_corners(const ScenePrimitive& primitive, PixelPosition pixel,
                                  Fixed reach) {
  // The position of a quotient is known to the nearest multiple of 2^-16.
  const std::int64_t margin = reach.raw() + (has_clip_positions(primitive) ? 1 : 0);
  std::array<Point, 3> p;
  std::transform(primitive.positions.begin(), primitive.positions.end(), p.begin(), nearest_point);
  const auto square = half_planes_of(pixel);
  HalfPlanes planes(square.begin(), square.end());
  switch (primitive.kind) {
    case PrimitiveKind::point:
      add_box(planes, {p.data(), 1}, (primitive.state->point_size.raw() + 1) / 2 + margin);
      break;
    case PrimitiveKind::line:
      add_rectangle(planes, {p[0], p[1]}, primitive.state->line_width, pixel, margin);
      break;
    case PrimitiveKind::triangle:
      add_triangle(planes, p, margin);
      break;
  }
  std::vector<Point> corners = corners_of(planes);
  return corners.empty() ? corners_of_pixel(pixel) : corners;
}

}  // namespace

std::vector<Point> permitted_locations(const ScenePrimitive& primitive, PixelPosition pixel,
                                       Point sample, Fixed reach) {
  const Multisampling& use = primitive.state->multisampling;
  if (!use.enabled) return corners_of_pixel(pixel);
  if (is_at_sample(use)) return {place_in(pixel, sample)};
  if (use.location == AttributeLocation::centroid) return shared_corners(primitive, pixel, reach);
  return corners_of_pixel(pixel);
}

std::vector<Point> permitted_coordinate_locations(const Multisampling& use, PixelPosition pixel,
                                                  Point sample) {
  if (use.enabled && use.min_sample_shading == 1.0F) return {place_in(pixel, sample)};
  return corners_of_pixel(pixel);
}

// ------------------------------------------------------------------------------------- half planes

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
