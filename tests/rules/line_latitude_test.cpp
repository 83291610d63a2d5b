// SPDX-License-Identifier: MIT
//
// Rulings 1 and 2 against right and deliberately wrong lines.
#include "rules/coverage/line_latitude.h"

#include <gtest/gtest.h>

#include "rules/coverage/diamond_exit.h"
#include "tests/rules/support.h"

namespace edgecase {
namespace {

constexpr PixelBounds kTarget{0, 0, 15, 15};
const Segment kShallow{at(2.5, 5.5), at(10.5, 8.5)};
const Segment kSteep{at(5.5, 2.5), at(8.5, 10.5)};

std::vector<PixelPosition> exact(const Segment& segment) {
  return diamond_exit_pixels(segment, kTarget, *find_diamond_boundary("left-bottom"));
}

std::vector<PixelPosition> shifted(std::vector<PixelPosition> pixels, int x, int y) {
  for (PixelPosition& p : pixels) p = {p.x + x, p.y + y};
  return pixels;
}

bool legal(const Segment& segment, const std::vector<PixelPosition>& drawn) {
  return broken_line_clause({segment, 1, kTarget}, drawn).empty();
}

TEST(LineLatitude, ExactIsLegal) {
  for (const Segment& segment : {kShallow, kSteep}) EXPECT_TRUE(legal(segment, exact(segment)));
}

TEST(LineLatitude, OneUnitIsLegalTwoAreNot) {
  for (const Segment& segment : {kShallow, kSteep}) {
    EXPECT_TRUE(legal(segment, shifted(exact(segment), 1, 0)));
    EXPECT_TRUE(legal(segment, shifted(exact(segment), 0, 1)));
    EXPECT_FALSE(legal(segment, shifted(exact(segment), 2, 0)));
    EXPECT_FALSE(legal(segment, shifted(exact(segment), 0, 2)));
  }
}

TEST(LineLatitude, OneMoreOrLessIsLegalTwoAreNot) {
  auto pixels = exact(kShallow);
  pixels.push_back({10, 8});
  EXPECT_TRUE(legal(kShallow, pixels));
  pixels.push_back({11, 9});
  EXPECT_FALSE(legal(kShallow, pixels));
  pixels = exact(kShallow);
  pixels.pop_back();
  EXPECT_TRUE(legal(kShallow, pixels));
  pixels.pop_back();
  EXPECT_FALSE(legal(kShallow, pixels));
}

TEST(LineLatitude, TwoInAColumnOrRowAreIllegal) {
  auto shallow = exact(kShallow);
  shallow.back() = {shallow.front().x, shallow.front().y + 1};
  EXPECT_EQ(broken_line_clause({kShallow, 1, kTarget}, shallow),
            "column 2 holds two fragments of one segment");
  auto steep = exact(kSteep);
  steep.back() = {steep.front().x + 1, steep.front().y};
  EXPECT_EQ(broken_line_clause({kSteep, 1, kTarget}, steep),
            "row 2 holds two fragments of one segment");
}

TEST(LineLatitude, AFarStrayIsIllegal) {
  auto pixels = exact(kShallow);
  pixels.back() = {14, 14};
  EXPECT_EQ(broken_line_clause({kShallow, 1, kTarget}, pixels),
            "pixel (14, 14) has no diamond-exit fragment within one unit");
}

TEST(LineLatitude, AnEmptyAnswerIsIllegal) {
  EXPECT_FALSE(legal(kShallow, {}));
}

TEST(LineLatitude, OfAnEmptySetOneTouchedDiamondMayBeDrawn) {
  const Segment inside{at(5.4375, 5.5), at(5.5625, 5.5)};
  EXPECT_TRUE(legal(inside, {}));
  EXPECT_TRUE(legal(inside, {{5, 5}}));
  EXPECT_FALSE(legal(inside, {{6, 5}}));
  EXPECT_FALSE(legal(inside, {{5, 5}, {5, 6}}));
}

TEST(LineLatitude, WhatTheBorderHidesIsNotHeldAgainstALine) {
  // Half of this segment lies left of the target; its seen part must still be drawn.
  const Segment leaving{at(-4.5, 5.5), at(5.5, 5.5)};
  EXPECT_TRUE(legal(leaving, exact(leaving)));
  EXPECT_FALSE(legal(leaving, {}));
}

}  // namespace
}  // namespace edgecase
