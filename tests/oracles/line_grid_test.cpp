// SPDX-License-Identifier: MIT
//
// Every segment with its ends on a quarter grid of 2x2 pixels, drawn by every algorithm under every
// ownership of boundaries, against the oracles; and wide lines on a half grid.
#include <gtest/gtest.h>

#include "rules/coverage/diamond_exit.h"
#include "tests/oracles/support.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

constexpr PixelBounds kWindow{-1, -1, 2, 2};

// Every segment between two points of a grid of 2x2 pixels, steps in raw units.
std::vector<Segment> segments(std::int64_t step) {
  const auto ends = grid(0, 2 * Fixed::kOne, step);
  std::vector<Segment> result;
  for (Point a : ends)
    for (Point b : ends) result.push_back({a, b});
  return result;
}

// Compares all of the segments, as the scene draws them.
void compare(LineScene scene, const std::vector<Segment>& all, Dealer& dealer, Tally& tally) {
  for (const Segment& segment : all) {
    if (!dealer.deal()) continue;
    scene.segment = segment;
    ASSERT_TRUE(agrees(scene, kWindow, tally));
  }
}

TEST(LineGrid, EveryThinLineOnAQuarterGrid) {
  const auto all = segments(Fixed::kOne / 4);
  const auto kinds = thin_line_kinds();
  EXPECT_EQ(kinds.size(), 12u + 12 + 2 * 10 + 6);
  Dealer dealer;
  Tally tally;
  for (const LineScene& kind : kinds) ASSERT_NO_FATAL_FAILURE(compare(kind, all, dealer, tally));
  tally.print("thin lines on a grid");
  EXPECT_EQ(dealer.items(), 50L * 81 * 81);
  EXPECT_GT(tally.tied, tally.scenes / 3);
}

constexpr std::int64_t kWideQuarters[] = {2, 5, 6, 8, 12};

// Moved half a pixel down, a line of width 2 lies on the half grid again.
TEST(LineGrid, EveryWideLineOnAHalfGrid) {
  const auto all = segments(Fixed::kOne / 2);
  Dealer dealer;
  Tally tally;
  for (LineScene scene : thin_line_kinds())
    for (std::int64_t quarters : kWideQuarters) {
      scene.width = Fixed::from_raw(quarters * Fixed::kOne / 4);
      ASSERT_NO_FATAL_FAILURE(compare(scene, all, dealer, tally));
    }
  tally.print("replicated lines on a grid");
  EXPECT_EQ(dealer.items(), 50L * 5 * 25 * 25);
}

TEST(LineGrid, EveryWideAreaOnAHalfGrid) {
  const auto all = segments(Fixed::kOne / 2);
  Dealer dealer;
  Tally tally;
  LineScene scene;
  for (WideLine wide : {WideLine::rectangle, WideLine::parallelogram})
    for (const TieRule& ties : all_tie_rules())
      for (std::int64_t quarters : kWideQuarters) {
        scene.wide = wide;
        scene.ties = ties.name;
        scene.width = Fixed::from_raw(quarters * Fixed::kOne / 4);
        ASSERT_NO_FATAL_FAILURE(compare(scene, all, dealer, tally));
      }
  tally.print("wide areas on a grid");
  EXPECT_EQ(dealer.items(), 2L * 10 * 5 * 25 * 25);
}

// Every set of parts that a diamond can own, not only those that someone uses.
TEST(LineGrid, EveryOwnershipOfADiamond) {
  const auto all = segments(Fixed::kOne / 2);
  Dealer dealer;
  for (unsigned parts = 0; parts < 256; ++parts) {
    const auto has = [&](DiamondPart part) { return (parts & part) != 0; };
    const oracle::Owned owned{has(kLowerLeftEdge),  has(kLowerRightEdge), has(kUpperLeftEdge),
                              has(kUpperRightEdge), has(kLeftCorner),     has(kRightCorner),
                              has(kBottomCorner),   has(kTopCorner)};
    const DiamondBoundary ours{"some", nullptr, parts, ~parts};
    oracle::Boundary theirs{{0, 0}, owned, owned};
    for (bool* part :
         {&theirs.y_major.lower_left, &theirs.y_major.lower_right, &theirs.y_major.upper_left,
          &theirs.y_major.upper_right, &theirs.y_major.left, &theirs.y_major.right,
          &theirs.y_major.bottom, &theirs.y_major.top})
      *part = !*part;
    for (const Segment& segment : all) {
      if (!dealer.deal()) continue;
      const oracle::Line line = oracle_line(segment);
      ASSERT_EQ(meets_diamond(segment, 0, 0, ours), oracle::meets_diamond(line, theirs, 0, 0))
          << parts << " " << describe(segment);
      ASSERT_EQ(ends_in_diamond(segment, 0, 0, ours), oracle::ends_in_diamond(line, theirs, 0, 0))
          << parts << " " << describe(segment);
    }
  }
}

}  // namespace
}  // namespace edgecase
