// SPDX-License-Identifier: MIT
//
// What a clipped triangle may cover: of three vertices and far from the viewport's sides the same
// as a triangle; of more, the same as all moves of its vertices on a small grid.
#include "rules/coverage/clip_polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "rules/coverage/triangle_fill.h"

namespace edgecase {
namespace {

constexpr Viewport kWide{-16, -16, 64, 64};
const Fixed kReach = Fixed::from_raw(Fixed::kOne / 4);

Point quarters(std::int64_t x, std::int64_t y) {
  return {Fixed::from_raw(x * Fixed::kOne / 4), Fixed::from_raw(y * Fixed::kOne / 4)};
}

std::vector<Point> reversed(std::vector<Point> vertices) {
  std::reverse(vertices.begin(), vertices.end());
  return vertices;
}

TEST(ClipLatitude, OfThreeVerticesIsThatOfATriangle) {
  std::mt19937 random(7);
  std::uniform_int_distribution<std::int64_t> coordinate(0, 16);
  int covered = 0, uncovered = 0;
  for (int round = 0; round < 600; ++round) {
    Triangle t;
    for (Point& p : t) p = quarters(coordinate(random), coordinate(random));
    if (doubled_area(t) == 0) continue;
    const LoosePolygon polygon{{t.begin(), t.end()}, kReach, kWide};
    const LoosePolygon turned{reversed(polygon.vertices), kReach, kWide};
    for (int y = -2; y <= 18; ++y)
      for (int x = -2; x <= 18; ++x) {
        const Point sample = quarters(x, y);
        const bool may = triangle_possibly_covered(t, sample, kReach);
        const bool may_not = triangle_possibly_uncovered(t, sample, kReach);
        ASSERT_EQ(polygon_possibly_covered(polygon, sample), may) << round << " " << x << " " << y;
        ASSERT_EQ(polygon_possibly_covered(turned, sample), may) << round << " " << x << " " << y;
        ASSERT_EQ(polygon_possibly_uncovered(polygon, sample), may_not) << round;
        ASSERT_EQ(polygon_possibly_uncovered(turned, sample), may_not) << round;
        covered += may;
        uncovered += may_not;
      }
  }
  EXPECT_GT(covered, 10000);
  EXPECT_GT(uncovered, 10000);
}

// A square of 2 pixels: what lies nearer to its border than the reach may be either.
TEST(ClipLatitude, OfASquare) {
  const LoosePolygon square{
      {quarters(4, 4), quarters(12, 4), quarters(12, 12), quarters(4, 12)}, kReach, kWide};
  for (int y = 0; y <= 16; ++y)
    for (int x = 0; x <= 16; ++x) {
      const bool near = x > 3 && x < 13 && y > 3 && y < 13;
      const bool deep = x >= 5 && x <= 11 && y >= 5 && y <= 11;
      EXPECT_EQ(polygon_possibly_covered(square, quarters(x, y)), near) << x << " " << y;
      EXPECT_EQ(polygon_possibly_uncovered(square, quarters(x, y)), !deep) << x << " " << y;
    }
}

// Edges that clipping made along the viewport's sides stay where they are.
TEST(ClipLatitude, TheViewportsSidesStay) {
  const std::vector<Point> vertices{quarters(4, 4), quarters(12, 4), quarters(12, 12),
                                    quarters(4, 12)};
  const auto covered = [&](const Viewport& viewport, int x, int y) {
    return polygon_possibly_covered({vertices, kReach, viewport}, quarters(x, y));
  };
  const auto uncovered = [&](const Viewport& viewport, int x, int y) {
    return polygon_possibly_uncovered({vertices, kReach, viewport}, quarters(x, y));
  };
  const Viewport same{1, 1, 2, 2}, wider{1, 1, 8, 2}, taller{1, 1, 2, 8}, left_of{-1, 0, 4, 8};
  for (int y = 4; y <= 12; ++y)
    for (int x = 4; x <= 12; ++x) {
      EXPECT_TRUE(covered(same, x, y));
      EXPECT_FALSE(uncovered(same, x, y));
    }
  // Away from the ends of edges, about which these may turn.
  for (int along = 6; along <= 10; ++along)
    for (int across = 4; across <= 12; ++across) {
      const bool first = across == 4, last = across == 12;
      EXPECT_EQ(uncovered(wider, across, along), last);
      EXPECT_EQ(uncovered(taller, along, across), last);
      EXPECT_EQ(uncovered(left_of, across, along), first);
      EXPECT_EQ(uncovered(left_of, along, across), first || last);
    }
  // Beyond them nothing is covered, however near.
  for (const auto& [x, y] : {std::pair{3, 8}, {13, 8}, {8, 3}, {8, 13}}) {
    EXPECT_FALSE(covered(same, x, y));
    EXPECT_TRUE(uncovered(same, x, y));
  }
}

// Of a closed curve: how often it runs round the point.
int winding(const std::vector<Point>& polygon, Point p) {
  int turns = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const std::int64_t side = (b.x.raw() - a.x.raw()) * (p.y.raw() - a.y.raw()) -
                              (b.y.raw() - a.y.raw()) * (p.x.raw() - a.x.raw());
    if (a.y <= p.y && b.y > p.y && side > 0) ++turns;
    if (a.y > p.y && b.y <= p.y && side < 0) --turns;
  }
  return turns;
}

// The line through a short edge turns far, and across samples in the midst of the polygon. No move
// of the vertices leaves these out.
TEST(ClipLatitude, AShortEdgeExcusesNothingFarFromIt) {
  const std::vector<Point> given{quarters(0, 0), quarters(32, 0), quarters(32, 31),
                                 quarters(31, 32), quarters(0, 32)};
  const LoosePolygon polygon{given, kReach, kWide};
  const Fixed step = kReach - Fixed::from_raw(1);
  std::vector<Point> certain;
  int swept = 0;
  for (int y = -2; y <= 34; ++y)
    for (int x = -2; x <= 34; ++x) {
      if (polygon_possibly_uncovered(polygon, quarters(x, y))) continue;
      certain.push_back(quarters(x, y));
      swept += robustly_left(given[2], given[3], quarters(x, y), kReach) ? 0 : 1;
    }
  EXPECT_GT(swept, 50);
  // All but the corner that is cut off, by the steps from the border that the reach leaves.
  EXPECT_GT(certain.size(), 29U * 29U);
  for (int moves = 0; moves < 9 * 9 * 9 * 9 * 9; moves += 7) {
    std::vector<Point> moved = given;
    int rest = moves;
    for (Point& p : moved) {
      p.x = p.x + (rest % 3 == 0 ? Fixed() - step : rest % 3 == 1 ? Fixed() : step);
      p.y = p.y + (rest / 3 % 3 == 0 ? Fixed() - step : rest / 3 % 3 == 1 ? Fixed() : step);
      rest /= 9;
    }
    for (std::size_t i = static_cast<std::size_t>(moves % 11); i < certain.size(); i += 11)
      ASSERT_EQ(winding(moved, certain[i]), 1) << moves;
  }
}

TEST(ClipLatitude, OfNothingIsNothing) {
  for (const std::vector<Point>& few :
       {std::vector<Point>{}, {quarters(4, 4)}, {quarters(4, 4), quarters(12, 12)}}) {
    EXPECT_FALSE(polygon_possibly_covered({few, kReach, kWide}, quarters(8, 8)));
    EXPECT_TRUE(polygon_possibly_uncovered({few, kReach, kWide}, quarters(8, 8)));
  }
}

}  // namespace
}  // namespace edgecase
