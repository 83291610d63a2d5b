// SPDX-License-Identifier: MIT
//
// permitted_locations: every place that a pixel and a primitive share, for every move of the
// vertices, lies in the region, and the region is hardly larger.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "rules/coverage/line_areas.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/samples/attribute_location.h"
#include "tests/rules/samples/held_primitive.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

constexpr PixelPosition kPixel{1, 1};

class Random {
 public:
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(engine_);
  }
  Point point() {
    const auto one = [&] { return Fixed::from_raw(between(-8, 32) * 8192); };
    const Fixed x = one();
    return {x, one()};
  }
  Point moved(Point p, Fixed reach) {
    const std::int64_t most = std::max<std::int64_t>(reach.raw() - 1, 0);
    return {p.x + Fixed::from_raw(between(-most, most)),
            p.y + Fixed::from_raw(between(-most, most))};
  }

 private:
  std::mt19937_64 engine_{9};
};

// Does the convex hull of the corners hold the point? It does where no line through two of them
// has all corners on one side and the point on the other.
bool hull_holds(const std::vector<Point>& corners, Point p) {
  if (corners.size() == 1) return corners[0] == p;
  for (Point a : corners)
    for (Point b : corners) {
      if (a == b) continue;
      const bool is_side =
          std::all_of(corners.begin(), corners.end(), [&](Point c) { return cross(a, b, c) >= 0; });
      if (is_side && cross(a, b, p) < 0) return false;
    }
  return true;
}

bool covers(PrimitiveKind kind, const std::array<Point, 3>& p, Fixed size, Point sample) {
  const TieRule& closed = *find_tie_rule("closed");
  switch (kind) {
    case PrimitiveKind::point:
      return point_covers({p[0], size}, sample, closed);
    case PrimitiveKind::line:
      return line_area_covers({p[0], p[1]}, size, LineArea::rectangle, sample, closed);
    case PrimitiveKind::triangle: {
      const Triangle t = counter_clockwise(p);
      return doubled_area(t) != 0 && cross(t[0], t[1], sample) >= 0 &&
             cross(t[1], t[2], sample) >= 0 && cross(t[2], t[0], sample) >= 0;
    }
  }
  return false;
}

class CentroidRegion : public testing::TestWithParam<PrimitiveKind> {};

TEST_P(CentroidRegion, HoldsEveryPlaceThatMovesShare) {
  Random random;
  int held = 0;
  int outside = 0;
  for (int round = 0; round < 600; ++round) {
    const Fixed reach = Fixed::from_raw(round % 3 == 0 ? 1 : Fixed::kOne >> random.between(2, 8));
    const Fixed size = Fixed::from_raw(random.between(1, 8) * Fixed::kOne / 4);
    const std::array<Point, 3> given = {random.point(), random.point(), random.point()};
    const Held shape(GetParam(), given, size, AttributeLocation::centroid);
    const auto corners = permitted_locations(shape.primitive, kPixel, {}, reach);
    ASSERT_FALSE(corners.empty());
    bool is_shared = false;
    for (int move = 0; move < 4; ++move) {
      std::array<Point, 3> p = given;
      if (move > 0)
        for (Point& vertex : p) vertex = random.moved(vertex, reach);
      for (int y = 0; y <= 16; ++y)
        for (int x = 0; x <= 16; ++x) {
          const Point place =
              place_in(kPixel, {Fixed::from_raw(x * 4096), Fixed::from_raw(y * 4096)});
          if (!covers(GetParam(), p, size, place)) continue;
          is_shared = true;
          ++held;
          ASSERT_TRUE(hull_holds(corners, place)) << round;
        }
    }
    for (Point corner : corners) {
      EXPECT_GE(corner.x, Fixed::from_integer(1));
      EXPECT_LE(corner.x, Fixed::from_integer(2));
    }
    if (is_shared && !hull_holds(corners, pixel_centre(1, 1))) ++outside;
  }
  EXPECT_GT(held, 20000);
  EXPECT_GT(outside, 30);  // an evaluation at the centre would be told
}

INSTANTIATE_TEST_SUITE_P(Kinds, CentroidRegion,
                         testing::Values(PrimitiveKind::point, PrimitiveKind::line,
                                         PrimitiveKind::triangle));

}  // namespace
}  // namespace edgecase
