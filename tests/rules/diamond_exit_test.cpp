// SPDX-License-Identifier: MIT
//
// Drawn examples of the diamond-exit rule, worked out by hand from GL 4.6 core, 14.5.1.
#include "rules/coverage/diamond_exit.h"

#include <gtest/gtest.h>

#include "tests/rules/support.h"

namespace edgecase {
namespace {

const DiamondBoundary& gl() {
  return *find_diamond_boundary("left-bottom");
}

std::string draw(Point a, Point b, int width, int height) {
  std::string rows;
  for (int y = height - 1; y >= 0; --y) {
    for (int x = 0; x < width; ++x) rows += diamond_exit_covers({a, b}, x, y, gl()) ? '#' : '.';
    rows += '/';
  }
  return rows;
}

TEST(DiamondExit, IsHalfOpenBetweenPixelCentres) {
  EXPECT_EQ(draw(at(0.5, 0.5), at(3.5, 0.5), 5, 1), "###../");
  EXPECT_EQ(draw(at(3.5, 0.5), at(0.5, 0.5), 5, 1), ".###./");
  EXPECT_EQ(draw(at(0.5, 0.5), at(0.5, 3.5), 1, 5), "././#/#/#/");
}

// Moved by -(e, e^2), a horizontal line at integer y runs e^2 below it, from left of x = 0.5 to
// left of x = 3.5. It enters the diamonds of the row below at their top corners, at x = 0.5, 1.5
// and 2.5; the one at 3.5 lies e ahead of its end.
TEST(DiamondExit, AnIntegerRowGoesToTheRowBelow) {
  EXPECT_EQ(draw(at(0.5, 1), at(3.5, 1), 4, 2), "..../###./");
}

TEST(DiamondExit, AnIntegerColumnGoesToTheColumnLeft) {
  EXPECT_EQ(draw(at(1, 0.5), at(1, 2.5), 2, 3), "../#./#./");
}

TEST(DiamondExit, ZeroLengthDrawsNothing) {
  for (double x : {0.5, 0.25, 1.0}) EXPECT_EQ(draw(at(x, 0.5), at(x, 0.5), 2, 1), "../");
}

TEST(DiamondExit, ASegmentInsideOneDiamondDrawsNothing) {
  EXPECT_EQ(draw(at(0.4375, 0.5), at(0.5625, 0.5), 2, 1), "../");
}

TEST(DiamondExit, AnEndOnTheFarCornerHasExited) {
  // The right corner of pixel 0 is (1, 0.5); moved by -(e, e^2) it lies inside the diamond.
  EXPECT_EQ(draw(at(0.5, 0.5), at(1, 0.5), 2, 1), "../");
  // The left corner of pixel 1, from the right: moved left it lies outside, in no diamond at all.
  EXPECT_EQ(draw(at(1.5, 0.5), at(1, 0.5), 2, 1), ".#/");
}

TEST(DiamondExit, SlopeOneCountsAsXMajor) {
  EXPECT_TRUE((Segment{at(0, 0), at(2, 2)}).x_major());
  EXPECT_TRUE((Segment{at(0, 0), at(2, -2)}).x_major());
  EXPECT_FALSE((Segment{at(0, 0), at(1, 2)}).x_major());
  EXPECT_EQ(draw(at(0.5, 0.5), at(3.5, 3.5), 4, 4), "..../..#./.#../#.../");
}

TEST(DiamondExit, CoordinatesAtTheEndOfTheRangeDoNotOverflow) {
  const double far = 8192;
  const double tiny = 1.0 / 65536;
  const Segment segment{at(-far, -far), at(far, far - tiny)};
  EXPECT_TRUE(meets_diamond(segment, 0, 0, gl()));
  EXPECT_FALSE(meets_diamond(segment, 8191, -8192, gl()));
  EXPECT_EQ(diamond_exit_pixels(segment, {0, 0, 99, 99}, gl()).size(), 100u);
}

TEST(DiamondExit, ExplanationNamesTheTieAndTheNumbers) {
  const std::string tie = explain_line({at(0.5, 1), at(3.5, 1)}, 1, 0, gl()).text;
  EXPECT_NE(tie.find("only touches"), std::string::npos) << tie;
  const std::string miss = explain_line({at(0.5, 0.5), at(3.5, 0.5)}, 1, 1, gl()).text;
  EXPECT_NE(miss.find("comes within 1 of the centre (1.5, 1.5)"), std::string::npos) << miss;
}

}  // namespace
}  // namespace edgecase
