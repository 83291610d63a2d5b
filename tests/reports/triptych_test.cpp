// SPDX-License-Identifier: MIT
#include "reports/triptych.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "tests/reports/sample.h"

namespace edgecase {
namespace {

using Color = std::array<int, 3>;

// A black case of the given size with one answer that is the same.
CaseResults black(int width, int height) {
  CaseResults one;
  one.width = width;
  one.height = height;
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(4 * width * height));
  for (std::size_t at = 3; at < pixels.size(); at += 4) pixels[at] = 255;
  one.pixels = pixels;
  one.results.resize(1);
  one.results[0].verdict = Verdict::agree;
  one.results[0].pixels = one.pixels;
  return one;
}

void paint(Shared<PackedWords>& picture, int width, int x, int y) {
  std::vector<std::uint8_t> pixels = picture->bytes();
  const auto at = static_cast<std::ptrdiff_t>(4 * (y * width + x));
  std::fill(pixels.begin() + at, pixels.begin() + at + 4, 255);
  picture = pixels;
}

Color at(const Triptych& triptych, int x, int y) {
  const auto index = static_cast<std::size_t>(4 * (y * triptych.width + x));
  return {triptych.rgba[index], triptych.rgba[index + 1], triptych.rgba[index + 2]};
}

// The panels' first columns.
int second(const CaseResults& one, const Triptych& triptych) {
  return (triptych.width - one.width) / 2;
}
int third(const CaseResults& one, const Triptych& triptych) {
  return triptych.width - one.width;
}

TEST(Triptych, NoneWhereNothingDiffersOrNothingCame) {
  CaseResults one = black(4, 3);
  EXPECT_FALSE(triptych_of(one, one.results[0]));
  one.results[0].pixels = {};
  one.results[0].disagreements = {sample::disagreement(0, 0, DisagreementKind::extra, false)};
  EXPECT_FALSE(triptych_of(one, one.results[0]));
}

TEST(Triptych, ShowsExactDifferenceAndRenderedWithYUp) {
  CaseResults one = black(4, 3);
  paint(one.pixels, 4, 1, 0);
  one.results[0].disagreements = {sample::disagreement(1, 0, DisagreementKind::missing, false)};
  const auto triptych = triptych_of(one, one.results[0]);
  ASSERT_TRUE(triptych);
  EXPECT_EQ(triptych->height, 3);
  EXPECT_EQ(triptych->scale, 16);
  EXPECT_EQ(triptych->width, 3 * 4 + 2);
  EXPECT_EQ(triptych->rgba.size(), static_cast<std::size_t>(4 * triptych->width * 3));
  EXPECT_EQ(at(*triptych, 1, 0), (Color{255, 255, 255}));
  EXPECT_EQ(at(*triptych, 1, 2), (Color{0, 0, 0}));
  EXPECT_EQ(at(*triptych, second(one, *triptych) + 1, 0), (Color{43, 140, 255}));
  EXPECT_EQ(at(*triptych, second(one, *triptych) + 2, 0), (Color{255, 255, 255}));
  EXPECT_EQ(at(*triptych, third(one, *triptych) + 1, 0), (Color{0, 0, 0}));
}

TEST(Triptych, KindsHaveColoursOfTheirOwnAndAlphaCounts) {
  CaseResults one = black(8, 1);
  int x = 0;
  for (const auto kind : {DisagreementKind::missing, DisagreementKind::extra,
                          DisagreementKind::duplicate, DisagreementKind::value})
    one.results[0].disagreements.push_back(sample::disagreement(x++, 0, kind, true));
  std::vector<std::uint8_t> pixels = one.pixels->bytes();
  pixels[4 * 4 + 3] = 0;  // alpha alone, listed nowhere
  one.results[0].pixels = pixels;
  const auto triptych = triptych_of(one, one.results[0]);
  ASSERT_TRUE(triptych);
  std::set<Color> colors;
  for (x = 0; x < 6; ++x) colors.insert(at(*triptych, second(one, *triptych) + x, 0));
  EXPECT_EQ(colors.size(), 6u);
  EXPECT_EQ(at(*triptych, second(one, *triptych) + 5, 0), (Color{255, 255, 255}));
}

// 5 pixels across, of a picture in which one would be lost.
TEST(Triptych, ASinglePixelOfALargePictureHasAHalo) {
  CaseResults one = black(512, 300);
  paint(one.results[0].pixels, 512, 200, 100);
  const auto triptych = triptych_of(one, one.results[0]);
  ASSERT_TRUE(triptych);
  EXPECT_EQ(triptych->scale, 2);
  const int panel = second(one, *triptych);
  int marked = 0;
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 512; ++x) marked += at(*triptych, panel + x, y) != Color{255, 255, 255};
  EXPECT_EQ(marked, 25);
  EXPECT_NE(at(*triptych, panel + 200, 100), at(*triptych, panel + 201, 100));
}

// As results of another tool may have it.
TEST(Triptych, APlaceOutsideThePictureIsPassedOver) {
  CaseResults one = black(2, 2);
  one.results[0].disagreements = {sample::disagreement(7, -3, DisagreementKind::extra, false)};
  EXPECT_TRUE(triptych_of(one, one.results[0]));
}

TEST(Triptych, IsHeldAgainstWhatTheAnswerWasHeldAgainst) {
  CaseResults one = black(2, 2);
  paint(one.results[0].pixels, 2, 0, 0);
  one.results[0].exact_pixels = one.results[0].pixels;
  EXPECT_FALSE(triptych_of(one, one.results[0]));
}

}  // namespace
}  // namespace edgecase
