// SPDX-License-Identifier: MIT
//
// Which two triangles share an edge, and where a hit is promised to be exactly one.
#include "rules/coverage/triangle_fill.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "rules/coverage/window.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

const Point kA = at(1, 1);
const Point kB = at(5, 2);
const Point kLeft = at(2, 6);    // to the left of a -> b
const Point kRight = at(4, -3);  // to its right

// All orders of three points.
std::vector<Triangle> orders_of(Triangle t) {
  return {{t[0], t[1], t[2]}, {t[0], t[2], t[1]}, {t[1], t[0], t[2]},
          {t[1], t[2], t[0]}, {t[2], t[0], t[1]}, {t[2], t[1], t[0]}};
}

TEST(SharedEdge, IsFoundInEveryOrderOfTheVertices) {
  for (const Triangle& first : orders_of({kA, kB, kLeft}))
    for (const Triangle& second : orders_of({kA, kB, kRight})) {
      const auto edge = shared_edge(first, second);
      ASSERT_TRUE(edge.has_value());
      EXPECT_EQ(edge->a, kA);
      EXPECT_EQ(edge->b, kB);
      EXPECT_EQ(edge->left, kLeft);
      EXPECT_EQ(edge->right, kRight);
      const auto back = shared_edge(second, first);
      ASSERT_TRUE(back.has_value());
      EXPECT_EQ(back->a, kB);
      EXPECT_EQ(back->b, kA);
      EXPECT_EQ(back->left, kRight);
      EXPECT_EQ(back->right, kLeft);
    }
}

TEST(SharedEdge, NeedsBothEndsAndOppositeSides) {
  for (const Triangle& first : orders_of({kA, kB, kLeft})) {
    // On the same side.
    for (const Triangle& second : orders_of({kA, kB, at(3, 7)}))
      EXPECT_FALSE(shared_edge(first, second).has_value());
    // One common vertex only, either one.
    for (const Triangle& second : orders_of({kA, at(5, -2), kRight}))
      EXPECT_FALSE(shared_edge(first, second).has_value());
    for (const Triangle& second : orders_of({at(0, -4), kB, kRight}))
      EXPECT_FALSE(shared_edge(first, second).has_value());
    // None.
    for (const Triangle& second : orders_of({at(8, 8), at(9, 8), at(8, 9)}))
      EXPECT_FALSE(shared_edge(first, second).has_value());
    // The same triangle.
    EXPECT_FALSE(shared_edge(first, {kA, kB, kLeft}).has_value());
    // Without area, in every place of the two.
    for (const Triangle& flat : orders_of({kA, kB, at(9, 3)})) {
      EXPECT_FALSE(shared_edge(first, flat).has_value());
      EXPECT_FALSE(shared_edge(flat, first).has_value());
    }
  }
}

TEST(SharedEdge, AreasOfOneUnitCount) {
  const double unit = 1.0 / 65536;
  const Triangle first{at(0, 0), at(unit, 0), at(0, unit)};
  const Triangle second{at(0, 0), at(unit, 0), at(unit, -unit)};
  for (const Triangle& a : orders_of(first))
    for (const Triangle& b : orders_of(second)) EXPECT_TRUE(shared_edge(a, b).has_value());
}

TEST(SharedEdge, PromisesNothingNearTheEndsOrTheOtherEdges) {
  const SharedEdge edge{at(0, 0), at(8, 0), at(4, 8), at(4, -8)};
  const double step = 1.0 / 16;
  EXPECT_TRUE(must_hit_once(edge, at(4, 0), grid_step(4)));
  EXPECT_TRUE(must_hit_once(edge, at(4, step / 2), grid_step(4)));
  EXPECT_TRUE(must_hit_once(edge, at(4, -step / 2), grid_step(4)));
  // One triangle holds these, whatever moves.
  EXPECT_FALSE(must_hit_once(edge, at(4, step), grid_step(4)));
  EXPECT_FALSE(must_hit_once(edge, at(4, -step), grid_step(4)));
  // A move of the outer edges may uncover these.
  for (double x : {0.0, step, 8 - step, 8.0})
    EXPECT_FALSE(must_hit_once(edge, at(x, 0), grid_step(4))) << x;
  for (double x : {2 * step, 8 - 2 * step})
    EXPECT_TRUE(must_hit_once(edge, at(x, 0), grid_step(4))) << x;
  // Each of the four outer edges by itself: the opposite corner pulled in until it comes near.
  const Point sample = at(4, 0);
  EXPECT_FALSE(must_hit_once({at(3.9375, 0), at(8, 0), at(4, 8), at(7, -8)}, sample, grid_step(4)));
  EXPECT_FALSE(must_hit_once({at(3.9375, 0), at(8, 0), at(7, 8), at(4, -8)}, sample, grid_step(4)));
  EXPECT_FALSE(must_hit_once({at(0, 0), at(4.0625, 0), at(1, 8), at(4, -8)}, sample, grid_step(4)));
  EXPECT_FALSE(must_hit_once({at(0, 0), at(4.0625, 0), at(4, 8), at(1, -8)}, sample, grid_step(4)));
}

}  // namespace
}  // namespace edgecase
