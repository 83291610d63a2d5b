// SPDX-License-Identifier: MIT
#include "rules/coverage/point_ownership.h"

#include <gtest/gtest.h>

#include "rules/coverage/window.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

TEST(PointOwnership, RightTopIsTheFloorOfTheVertex) {
  const TieRule& rule = *find_tie_rule("right-top");
  for (int i = 0; i <= 24; ++i)
    for (int j = 0; j <= 24; ++j)
      for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
          EXPECT_EQ(point_covers({at(i / 8.0, j / 8.0)}, x, y, rule), x == i / 8 && y == j / 8);
}

TEST(PointOwnership, LatitudeIsOpenWithinOneStep) {
  const double step = 1.0 / 256;
  EXPECT_TRUE(point_possibly_covered({at(1, 0.5)}, 0, 0, grid_step(8)));
  EXPECT_TRUE(point_possibly_covered({at(1 + step / 2, 0.5)}, 0, 0, grid_step(8)));
  EXPECT_FALSE(point_possibly_covered({at(1 + step, 0.5)}, 0, 0, grid_step(8)));
  EXPECT_TRUE(point_possibly_uncovered({at(1 - step / 2, 0.5)}, 0, 0, grid_step(8)));
  EXPECT_FALSE(point_possibly_uncovered({at(1 - step, 0.5)}, 0, 0, grid_step(8)));
}

}  // namespace
}  // namespace edgecase
