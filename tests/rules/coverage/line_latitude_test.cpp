// SPDX-License-Identifier: MIT
//
// Rulings 1 and 2 against right and deliberately wrong lines.
#include "rules/coverage/line_latitude.h"

#include <gtest/gtest.h>

#include "rules/coverage/diamond_exit.h"
#include "tests/support/points.h"

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

// From every place of a diamond to every place of another: whichever way an implementation moves
// ends that lie on a boundary, its lines are legal, and two fragments fewer or a stray one are not.
TEST(LineLatitude, EveryOrderOfTiesIsLegal) {
  const std::vector<std::pair<double, double>> places = {
      {0, 0},          {0.5, 0},         {0, 0.5},       {-0.5, 0},     {0, -0.5},
      {0.25, 0.25},    {-0.25, 0.25},    {-0.25, -0.25}, {0.25, -0.25}, {0.375, 0.375},
      {-0.375, 0.375}, {-0.375, -0.375}, {0.375, -0.375}};
  const std::vector<std::pair<int, int>> ways = {{4, 0},  {4, 4},   {0, 4},  {-4, 4},
                                                 {-4, 0}, {-4, -4}, {0, -4}, {4, -4}};
  int otherwise = 0;
  for (const auto& [dx, dy] : ways)
    for (const auto& [ax, ay] : places)
      for (const auto& [bx, by] : places) {
        const Segment segment{at(7.5 + ax, 7.5 + ay), at(7.5 + dx + bx, 7.5 + dy + by)};
        for (const DiamondBoundary& boundary : all_diamond_boundaries()) {
          if (boundary.ties == nullptr || boundary.ties->kind != TieRule::Kind::perturbed) continue;
          auto drawn = diamond_exit_pixels(segment, kTarget, boundary);
          otherwise += drawn.size() + 1 < exact(segment).size();
          ASSERT_EQ(broken_line_clause({segment, 1, kTarget}, drawn), "") << boundary.name;
          drawn.push_back({15, 15});
          ASSERT_NE(broken_line_clause({segment, 1, kTarget}, drawn), "") << boundary.name;
          drawn.resize(0);
          ASSERT_NE(broken_line_clause({segment, 1, kTarget}, drawn), "") << boundary.name;
        }
      }
  EXPECT_GT(otherwise, 0) << "some have two fragments fewer than the text's own order";
}

// Only what lies exactly on a boundary is open: a thousandth of a pixel beside it, two fewer are
// two too few.
TEST(LineLatitude, BesideATieNothingIsOpen) {
  const Segment tied{at(7.75, 7.75), at(11.25, 11.75)};
  const auto shorter = diamond_exit_pixels(tied, kTarget, *find_diamond_boundary("right-top"));
  EXPECT_TRUE(legal(tied, shorter));
  const Segment beside{at(7.749, 7.749), at(11.249, 11.751)};
  auto fewer = exact(beside);
  ASSERT_EQ(fewer.size(), exact(tied).size());
  ASSERT_EQ(fewer.size(), shorter.size() + 2);
  EXPECT_FALSE(legal(beside, shorter));
}

}  // namespace
}  // namespace edgecase
