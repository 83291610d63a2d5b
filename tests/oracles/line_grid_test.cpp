// SPDX-License-Identifier: MIT
//
// Every segment with its ends on a quarter grid of 2x2 pixels, drawn by every algorithm under every
// ownership of boundaries, against the oracles; and wide lines on a half grid.
#include <gtest/gtest.h>

#include "tests/oracles/support.h"

namespace edgecase {
namespace {

constexpr PixelBounds kWindow{-1, -1, 2, 2};

TEST(LineGrid, EveryThinLineOnAQuarterGrid) {
  const auto ends = grid(0, 2 * Fixed::kOne, Fixed::kOne / 4);
  const auto kinds = thin_line_kinds();
  EXPECT_EQ(kinds.size(), 12u + 12 + 2 * 10 + 6);
  Tally tally;
  for (LineScene scene : kinds)
    for (Point a : ends)
      for (Point b : ends) {
        scene.segment = {a, b};
        ASSERT_TRUE(agrees(scene, kWindow, tally));
      }
  tally.print("thin lines on a grid");
  EXPECT_EQ(tally.scenes, 50L * 81 * 81);
  EXPECT_GT(tally.tied, tally.scenes / 3);
}

// Moved half a pixel down, a line of width 2 lies on the quarter grid again.
TEST(LineGrid, EveryWideLineOnAHalfGrid) {
  const auto ends = grid(0, 2 * Fixed::kOne, Fixed::kOne / 2);
  Tally tally;
  for (LineScene scene : thin_line_kinds())
    for (std::int64_t quarters : {2, 5, 6, 8, 12})
      for (Point a : ends)
        for (Point b : ends) {
          scene.width = Fixed::from_raw(quarters * Fixed::kOne / 4);
          scene.segment = {a, b};
          ASSERT_TRUE(agrees(scene, kWindow, tally));
        }
  tally.print("replicated lines on a grid");
  EXPECT_EQ(tally.scenes, 50L * 5 * 25 * 25);
}

TEST(LineGrid, EveryWideAreaOnAHalfGrid) {
  const auto ends = grid(0, 2 * Fixed::kOne, Fixed::kOne / 2);
  Tally tally;
  LineScene scene;
  for (WideLine wide : {WideLine::rectangle, WideLine::parallelogram})
    for (const TieRule& ties : all_tie_rules())
      for (std::int64_t quarters : {2, 5, 6, 8, 12})
        for (Point a : ends)
          for (Point b : ends) {
            scene.wide = wide;
            scene.ties = ties.name;
            scene.width = Fixed::from_raw(quarters * Fixed::kOne / 4);
            scene.segment = {a, b};
            ASSERT_TRUE(agrees(scene, kWindow, tally));
          }
  tally.print("wide areas on a grid");
  EXPECT_EQ(tally.scenes, 2L * 10 * 5 * 25 * 25);
}

}  // namespace
}  // namespace edgecase
