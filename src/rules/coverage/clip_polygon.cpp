// SPDX-License-Identifier: MIT
#include "rules/coverage/clip_polygon.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include "exact/homogeneous.h"
#include "exact/rational.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {
namespace {

// A vertex (x/w, y/w, z/w), and the largest coordinates in its computation, over the same w.
struct WideVertex {
  Integer x, y, z, w;
  Integer sources = 0;  // 0: a vertex of the triangle
};
using WidePolygon = std::vector<WideVertex>;

Integer largest_of(const WideVertex& v) {
  return std::max({Integer(abs(v.x)), Integer(abs(v.y)), Integer(abs(v.w)), v.sources});
}

// The point at distance 0 between a, at `inside` >= 0 from a plane, and b, at `outside` < 0.
WideVertex between(const WideVertex& a, const Integer& inside, const WideVertex& b,
                   const Integer& outside) {
  const Integer share = -outside;
  const auto mixed = [&](const Integer& of_a, const Integer& of_b) {
    return Integer(of_a * share + of_b * inside);
  };
  WideVertex cut{mixed(a.x, b.x), mixed(a.y, b.y), mixed(a.z, b.z), mixed(a.w, b.w)};
  cut.sources = std::max(Integer(largest_of(a) * share), Integer(largest_of(b) * inside));
  return cut;
}

// The part of a polygon where `distance` is not negative.
template <class Distance>
WidePolygon cut_by(const WidePolygon& polygon, Distance distance) {
  WidePolygon left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const WideVertex& here = polygon[i];
    const WideVertex& next = polygon[(i + 1) % polygon.size()];
    const Integer at = distance(here);
    const Integer then = distance(next);
    if (at >= 0) left.push_back(here);
    if (at > 0 && then < 0) left.push_back(between(here, at, next, then));
    if (at < 0 && then > 0) left.push_back(between(next, then, here, at));
  }
  return left;
}

WidePolygon polygon_of(const UnclippedTriangle& triangle) {
  WidePolygon polygon;
  for (std::size_t i = 0; i < 3; ++i) {
    const HomogeneousPoint& p = triangle.positions[i];
    polygon.push_back({p.x, p.y, triangle.z[i], p.w});
  }
  return polygon;
}

// above / below for two integers, below > 0, to the nearest multiple of 2^-16, a tie upwards; at
// most 2^14 pixels away.
Fixed nearest(const Integer& above, const Integer& below) {
  const Integer raw =
      floor_of(Rational(Integer(2 * above * Fixed::kOne + below), Integer(2 * below)));
  const std::int64_t limit = 2 * Fixed::kMaxCoordinate * Fixed::kOne;
  return Fixed::from_raw(static_cast<std::int64_t>(std::clamp<Integer>(raw, -limit, limit)));
}

ClipPolygonVertex rounded(const WideVertex& v, std::int64_t parts) {
  ClipPolygonVertex result{{nearest(v.x, v.w), nearest(v.y, v.w)}, v.sources != 0, {}};
  // Two numbers are mixed and then divided by w: both steps may err by their part.
  if (result.made)
    result.error = nearest(Integer(2 * v.sources), Integer(v.w * parts)) + Fixed::from_raw(1);
  return result;
}

}  // namespace

std::vector<ClipPolygonVertex> clip_polygon(const UnclippedTriangle& triangle,
                                            const ClipPlanes& planes, std::int64_t parts) {
  WidePolygon polygon = polygon_of(triangle);
  if (planes.depth) {
    polygon = cut_by(polygon, [](const WideVertex& v) { return Integer(v.w + v.z); });
    polygon = cut_by(polygon, [](const WideVertex& v) { return Integer(v.w - v.z); });
  } else {
    polygon = cut_by(polygon, [](const WideVertex& v) { return v.w; });
  }
  const auto cut_at = [&](Integer WideVertex::*axis, int halves, int direction) {
    polygon = cut_by(polygon, [&](const WideVertex& v) {
      return Integer(direction * (2 * v.*axis - halves * v.w));
    });
  };
  cut_at(&WideVertex::x, planes.left, 1);
  cut_at(&WideVertex::x, planes.right, -1);
  cut_at(&WideVertex::y, planes.bottom, 1);
  cut_at(&WideVertex::y, planes.top, -1);
  std::vector<ClipPolygonVertex> vertices;
  for (const WideVertex& v : polygon)
    // A vertex in the eye itself has no direction: its neighbours replace it.
    if (v.w > 0) vertices.push_back(rounded(v, parts));
  if (vertices.size() < 3) vertices.clear();
  return vertices;
}

std::vector<ClipPolygonVertex> seen_polygon(const ScenePrimitive& triangle, std::int64_t parts) {
  return clip_polygon({triangle.positions, triangle.z}, sides_of(triangle.viewport), parts);
}

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

}  // namespace

bool is_on_viewport(Point a, Point b, const Viewport& viewport) {
  return is_side(a.x, b.x, viewport.x, viewport.width) ||
         is_side(a.y, b.y, viewport.y, viewport.height);
}

// As in triangle_possibly_covered: the union of all moved polygons is the sum of the polygon and an
// open square; an axis or an edge's normal separates every outside point from it.
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
    if (!left_and_apart(a, b, sample, polygon.reach)) return true;
  }
  return false;
}

}  // namespace edgecase
