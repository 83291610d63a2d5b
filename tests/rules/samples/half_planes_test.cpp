// SPDX-License-Identifier: MIT
#include "rules/samples/half_planes.h"

#include <gtest/gtest.h>

#include "tests/support/points.h"

namespace edgecase {
namespace {

using Points = std::vector<Point>;

// Crossings that are no multiples of 2^-16 are surrounded.
TEST(HalfPlanes, CornersAreRoundedOutwards) {
  const HalfPlane planes[] = {{-1, 0, 0}, {0, -1, 0}, {3, 3, 10}};
  EXPECT_EQ(corners_of(planes), (Points{raw(0, 0), raw(3, 0), raw(4, 0), raw(0, 3), raw(0, 4)}));
  const HalfPlane apart[] = {{-1, 0, -5}, {1, 0, 4}, {0, -1, 0}, {0, 1, 9}};
  EXPECT_TRUE(corners_of(apart).empty());
  // Half raw units, negative ones too.
  const HalfPlane fine[] = {{-2, 0, 1}, {2, 0, -1}, {0, -1, 7}, {0, 1, -7}};
  EXPECT_EQ(corners_of(fine), (Points{raw(-1, -7), raw(0, -7)}));
  const HalfPlane both[] = {{-2, 0, -3}, {2, 0, 3}, {0, -2, -3}, {0, 2, 3}};
  EXPECT_EQ(corners_of(both), (Points{raw(1, 1), raw(2, 1), raw(1, 2), raw(2, 2)}));
}

TEST(HalfPlanes, ACornerOfManyIsOne) {
  const HalfPlane star[] = {{-1, 0, 0}, {1, 0, 0},  {0, -1, 0}, {0, 1, 0},
                            {1, 1, 0},  {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}};
  EXPECT_EQ(corners_of(star), Points{raw(0, 0)});
}

TEST(HalfPlanes, OfAPixelAndOfEverything) {
  const std::int64_t one = Fixed::kOne;
  const Points corners = {raw(2 * one, -one), raw(3 * one, -one), raw(2 * one, 0), raw(3 * one, 0)};
  const auto square = half_planes_of({2, -1});
  EXPECT_EQ(corners_of(square), corners);
  const HalfPlane everything;
  EXPECT_TRUE(everything.normal_x == 0 && everything.normal_y == 0 && everything.limit == 0);
  const HalfPlane five[] = {square[0], everything, square[1], square[2], square[3]};
  EXPECT_EQ(corners_of(five), corners);
}

}  // namespace
}  // namespace edgecase
