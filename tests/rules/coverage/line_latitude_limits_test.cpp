// SPDX-License-Identifier: MIT
//
// Rulings 1, 2 and 12 at their limits: the greatest and smallest counts, what the target's border
// hides, and the words of a broken clause.
#include <gtest/gtest.h>

#include <algorithm>

#include "rules/coverage/line_latitude.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

using Pixels = std::vector<PixelPosition>;

constexpr PixelBounds kTarget{0, 0, 15, 15};

// Pixels of one row, both ends included.
Pixels row(int y, int first, int last) {
  Pixels pixels;
  for (int x = first; x <= last; ++x) pixels.push_back({x, y});
  return pixels;
}

std::string broken(const Segment& segment, const Pixels& drawn, int width = 1) {
  return broken_line_clause({segment, width, kTarget}, drawn);
}

Pixels turned(Pixels pixels) {
  for (PixelPosition& p : pixels) p = {p.y, p.x};
  return pixels;
}

Segment turned(const Segment& s) {
  return {{s.a.y, s.a.x}, {s.b.y, s.b.x}};
}

// The same of the segment with its axes exchanged. Ties differ then; the examples have none.
bool legal(const Segment& segment, const Pixels& drawn, int width = 1) {
  const bool result = broken(segment, drawn, width).empty();
  EXPECT_EQ(broken(turned(segment), turned(drawn), width).empty(), result);
  return result;
}

const Segment kInside{at(2.25, 5.25), at(10.25, 5.25)};  // exact: row 5, columns 2 to 9

TEST(LineCounts, MayBeOneMoreOrLess) {
  EXPECT_TRUE(legal(kInside, row(5, 2, 9)));
  EXPECT_TRUE(legal(kInside, row(5, 1, 9)));
  EXPECT_TRUE(legal(kInside, row(5, 2, 8)));
  EXPECT_EQ(broken(kInside, row(5, 1, 10)),
            "10 fragments are drawn where the diamond-exit rule has 8; one more or less is "
            "allowed");
  EXPECT_EQ(broken(kInside, row(5, 2, 7)),
            "6 fragments are drawn where the diamond-exit rule has 8; one more or less is "
            "allowed");
}

TEST(LineCounts, OfABorderRowMayBeNone) {
  const Segment border{at(2.25, 0.25), at(10.25, 0.25)};
  EXPECT_TRUE(legal(border, {}));
  EXPECT_TRUE(legal(border, row(0, 2, 9)));
  EXPECT_EQ(broken(border, row(0, 1, 10)),
            "10 fragments are drawn where the diamond-exit rule has 0 to 8 that may be seen; one "
            "more or less is allowed");
  // One row further inside all of them count.
  EXPECT_FALSE(legal({at(2.25, 1.25), at(10.25, 1.25)}, {}));
}

TEST(LineCounts, OfTheRowBeyondTheBorderMayBeAll) {
  // Row -1 for columns 0 to 3, row 0 for 4 to 7: drawn one unit higher all of it is seen.
  const Segment leaving{at(0.25, -0.875), at(8.25, 0.875)};
  EXPECT_TRUE(legal(leaving, row(0, 0, 7)));
  EXPECT_TRUE(legal(leaving, row(0, 4, 7)));
}

TEST(LineCounts, OfTheSecondRowBeyondTheBorderAreNone) {
  // Rows -2, -1 and 0, four columns each. Eight may be seen, and one more.
  const Segment leaving{at(0.25, -1.9375), at(12.25, 0.9375)};
  EXPECT_TRUE(legal(leaving, row(0, 4, 12)));
  EXPECT_FALSE(legal(leaving, row(0, 3, 12)));
}

TEST(UnseenLines, LieThreeUnitsOutside) {
  const auto unseen = [](double y) { return is_unseen({{at(2.25, y), at(10.25, y)}, 1, kTarget}); };
  EXPECT_FALSE(unseen(0.25));
  EXPECT_FALSE(unseen(-1.75));
  EXPECT_TRUE(unseen(-2.75));
  EXPECT_FALSE(unseen(17.25));
  EXPECT_TRUE(unseen(18.25));
}

TEST(EmptyLines, MayHaveOneFragmentNotTwo) {
  // Ends on the corner between two pixels, to whose diamonds it comes; moved, it leaves neither.
  const Segment inner{at(4.75, 5.5), at(5, 5.5)};
  EXPECT_EQ(broken(inner, {}), "");
  EXPECT_EQ(broken(inner, {{4, 5}}), "");
  EXPECT_EQ(broken(inner, {{5, 5}}), "");
  EXPECT_EQ(broken(inner, {{4, 5}, {5, 5}}),
            "2 fragments are drawn where the diamond-exit rule has none");
  EXPECT_EQ(broken(inner, {{3, 5}}),
            "pixel (3, 5) is drawn, and the segment does not meet its diamond");
}

// ------------------------------------------------------------------------------------ wide lines

// Runs of `rows` rows from the lowest, columns 2 to 9, in an order that no one expects.
Pixels runs(int lowest, int rows) {
  Pixels pixels;
  for (int x = 9; x >= 2; --x)
    for (int y = lowest; y < lowest + rows; ++y)
      pixels.insert(x % 2 == 0 ? pixels.end() : pixels.begin(), {x, y});
  return pixels;
}

TEST(WideLineCounts, RunsComeInAnyOrder) {
  const Segment segment{at(2.25, 6.25), at(10.25, 6.25)};  // width 3: rows 5 to 7
  Pixels pixels = runs(5, 3);
  EXPECT_TRUE(legal(segment, pixels, 3));
  std::reverse(pixels.begin(), pixels.end());
  EXPECT_TRUE(legal(segment, pixels, 3));
  pixels.pop_back();
  EXPECT_FALSE(legal(segment, pixels, 3));
}

TEST(WideLineCounts, ARunThatTheBorderCutsGoesOnBelowIt) {
  // Rows -2 to 0 by the rule, and one row of it seen. Drawn one higher: rows -1 to 1.
  const Segment low{at(2.25, -0.75), at(10.25, -0.75)};
  EXPECT_TRUE(legal(low, runs(0, 1), 3));
  EXPECT_TRUE(legal(low, runs(0, 2), 3));
  // Two higher: rows 0 to 2.
  EXPECT_FALSE(legal(low, runs(0, 3), 3));
  // All that is seen lies in the border's row, so it may be missing.
  EXPECT_TRUE(legal(low, {}, 3));
  // Rows -1 to 1: a row further inside, where it may not.
  EXPECT_FALSE(legal({at(2.25, 0.25), at(10.25, 0.25)}, {}, 3));
}

}  // namespace
}  // namespace edgecase
