// SPDX-License-Identifier: MIT
//
// Decisions that hang on one raw unit, each small case of them.
#include <gtest/gtest.h>

#include "rules/all_rules.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/scan_conversion.h"
#include "rules/coverage/triangle_algorithm.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/coverage/window.h"
#include "rules/values/framebuffer.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

// Moves of less than a unit: every corner of both, and the sample at the origin.
TEST(RobustlyLeft, IsWhatNoMoveOfTheEndsUndoes) {
  int yes = 0;
  for (int ax = -4; ax <= 4; ++ax)
    for (int ay = -4; ay <= 4; ++ay)
      for (int bx = -4; bx <= 4; ++bx)
        for (int by = -4; by <= 4; ++by) {
          int least = 1000;
          for (int i : {-1, 1})
            for (int j : {-1, 1})
              for (int k : {-1, 1})
                for (int l : {-1, 1})
                  least = std::min(least, (ax + i) * (by + l) - (ay + j) * (bx + k));
          ASSERT_EQ(robustly_left(raw(ax, ay), raw(bx, by), raw(0, 0), grid_step(16)), least >= 0)
              << ax << " " << ay << " " << bx << " " << by;
          yes += least >= 0 ? 1 : 0;
        }
  EXPECT_GT(yes, 100);
}

TEST(CounterClockwise, TurnsTheSmallestTriangle) {
  const Triangle left{raw(0, 0), raw(1, 0), raw(0, 1)};
  const Triangle right{raw(0, 0), raw(0, 1), raw(1, 0)};
  EXPECT_EQ(doubled_area(left), 1);
  EXPECT_EQ(doubled_area(right), -1);
  EXPECT_EQ(counter_clockwise(left), left);
  EXPECT_EQ(counter_clockwise(right), left);
}

TEST(TriangleLatitude, AFlatTriangleIsPossiblyCoveredNearItAlone) {
  const Triangle flat{at(1, 1), at(5, 3), at(9, 5)};
  const double step = 1.0 / 16;
  for (const Triangle& t :
       {flat, Triangle{flat[2], flat[0], flat[1]}, {flat[0], flat[0], flat[2]}}) {
    EXPECT_TRUE(triangle_possibly_covered(t, at(5, 3), grid_step(4)));
    // The sum of the segment and an open square: 1.5 steps above or below at this slope.
    EXPECT_TRUE(triangle_possibly_covered(t, at(5, 3 + 1.5 * step - 1.0 / 65536), grid_step(4)));
    EXPECT_FALSE(triangle_possibly_covered(t, at(5, 3 + 1.5 * step), grid_step(4)));
    EXPECT_TRUE(triangle_possibly_covered(t, at(5, 3 - 1.5 * step + 1.0 / 65536), grid_step(4)));
    EXPECT_FALSE(triangle_possibly_covered(t, at(5, 3 - 1.5 * step), grid_step(4)));
    EXPECT_TRUE(triangle_possibly_uncovered(t, at(5, 3), grid_step(4)));
  }
  const Triangle dot{at(5, 3), at(5, 3), at(5, 3)};
  EXPECT_TRUE(triangle_possibly_covered(dot, at(5, 3), grid_step(4)));
  EXPECT_TRUE(triangle_possibly_uncovered(dot, at(5, 3), grid_step(4)));
}

// The square of moves ends where it ends, on each of the four sides of a triangle's box.
TEST(TriangleLatitude, TheBoxGrowsByLessThanAStep) {
  const Triangle t{at(2, 2), at(6, 2), at(4, 6)};
  const double step = 1.0 / 16;
  const double unit = 1.0 / 65536;
  EXPECT_TRUE(triangle_possibly_covered(t, at(2 - step + unit, 2), grid_step(4)));
  EXPECT_FALSE(triangle_possibly_covered(t, at(2 - step, 2), grid_step(4)));
  EXPECT_TRUE(triangle_possibly_covered(t, at(6 + step - unit, 2), grid_step(4)));
  EXPECT_FALSE(triangle_possibly_covered(t, at(6 + step, 2), grid_step(4)));
  EXPECT_TRUE(triangle_possibly_covered(t, at(4, 2 - step + unit), grid_step(4)));
  EXPECT_FALSE(triangle_possibly_covered(t, at(4, 2 - step), grid_step(4)));
  EXPECT_TRUE(triangle_possibly_covered(t, at(4, 6 + step - unit), grid_step(4)));
  EXPECT_FALSE(triangle_possibly_covered(t, at(4, 6 + step), grid_step(4)));
}

TEST(PointLatitude, IsLessThanAStepOnEitherSide) {
  const double unit = 1.0 / 65536;
  // A size of 1 at 4 bits: the boundary lies 1/2 away, a step is 1/16.
  EXPECT_TRUE(point_possibly_covered({at(1.0625 - unit, 0.5)}, 0, 0, grid_step(4)));
  EXPECT_FALSE(point_possibly_covered({at(1.0625, 0.5)}, 0, 0, grid_step(4)));
  EXPECT_TRUE(point_possibly_uncovered({at(0.9375 + unit, 0.5)}, 0, 0, grid_step(4)));
  EXPECT_FALSE(point_possibly_uncovered({at(0.9375, 0.5)}, 0, 0, grid_step(4)));
  // Steps as fine as raw units.
  EXPECT_TRUE(point_possibly_uncovered({at(1, 0.5)}, 0, 0, grid_step(16)));
  EXPECT_FALSE(point_possibly_uncovered({at(1 - unit, 0.5)}, 0, 0, grid_step(16)));
}

TEST(Unorm8, RangesOutsideAreTheEnds) {
  const Unorm8Range above = unorm8_permitted(Interval(1.25, 1.5));
  EXPECT_EQ(above.low, 255);
  EXPECT_EQ(above.high, 255);
  const Unorm8Range below = unorm8_permitted(Interval(-1.5, -1.25));
  EXPECT_EQ(below.low, 0);
  EXPECT_EQ(below.high, 0);
}

TEST(PointOffsets, Move) {
  EXPECT_EQ(moved(at(2, 3), PointOffset::none), at(2, 3));
  EXPECT_EQ(moved(at(2, 3), PointOffset::right_down), at(2.125, 2.875));
}

TEST(RowOrders, RowsTurnOver) {
  EXPECT_EQ(turned_over(at(3.25, 2.5), 16), at(3.25, 13.5));
  const PixelBounds turned = turned_over(PixelBounds{2, 1, 7, 9}, 16);
  EXPECT_EQ(turned.x_min, 2);
  EXPECT_EQ(turned.y_min, 6);
  EXPECT_EQ(turned.x_max, 7);
  EXPECT_EQ(turned.y_max, 14);
}

TEST(TriangleScan, StaysWithinTheBounds) {
  const Triangle triangle{at(1.25, 0.5), at(15, 3.25), at(4, 14.75)};
  const auto all = scanned_triangle_pixels(triangle, {-50, -50, 50, 50});
  for (const PixelBounds& bounds : {PixelBounds{3, 4, 6, 7}, {5, 2, 9, 3}, {0, 0, 4, 20}}) {
    std::vector<PixelPosition> expected;
    for (PixelPosition p : all)
      if (bounds.contains(p)) expected.push_back(p);
    EXPECT_GT(expected.size(), 5u);
    EXPECT_EQ(scanned_triangle_pixels(triangle, bounds), expected);
  }
}

TEST(TriangleAlgorithms, EdgeFunctionsHaveATieRule) {
  EXPECT_TRUE(has_tie_rule(TriangleAlgorithm::edge_functions));
  EXPECT_TRUE(has_tie_rule(TriangleAlgorithm::float_edges));
  EXPECT_FALSE(has_tie_rule(TriangleAlgorithm::scan));
}

}  // namespace
}  // namespace edgecase
