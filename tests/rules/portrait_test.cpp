// SPDX-License-Identifier: MIT
#include "rules/portrait.h"

#include <gtest/gtest.h>

#include "rules/hypotheses.h"

namespace edgecase {
namespace {

const std::uint16_t kCorner = CoverageHypothesis{.place = SampledPlace::lower_left}.number();
const std::uint16_t kCornerOfWhole =
    CoverageHypothesis{.grid = VertexGrid::whole_truncated, .place = SampledPlace::lower_left}
        .number();
const std::uint16_t kOwnGrid = CoverageHypothesis{.grid = VertexGrid::reported}.number();
const auto kExchanged = static_cast<std::uint16_t>(ColorHypothesis::red_and_blue_exchanged);

// `count` answers that each of these explain, about coverage.
void add(int count, const std::vector<std::uint16_t>& numbers, PortraitGatherer& gatherer) {
  ResultOutline answer;
  answer.verdict = Verdict::violation;
  answer.standing = Standing::unexpected;
  for (const std::uint16_t number : numbers) answer.hypotheses.push_back({number, number});
  for (int i = 0; i < count; ++i) gatherer.add(answer);
}

TEST(Hypotheses, OfCoverageHaveANumberEach) {
  const CoverageHypothesis all{.grid = VertexGrid::whole_truncated,
                               .place = SampledPlace::lower_left,
                               .is_upside_down = true};
  EXPECT_TRUE(CoverageHypothesis::of(all.number()).is_upside_down);
  for (std::uint16_t number = 0; number < all.number(); ++number)
    ASSERT_EQ(CoverageHypothesis::of(number).number(), number);
}

TEST(Portrait, TellsTheHypothesisThatExplainsTheMost) {
  PortraitGatherer gatherer;
  add(5, {kCorner, kCornerOfWhole, kAskedOfCoverage}, gatherer);
  add(4, {kCornerOfWhole, kAskedOfCoverage}, gatherer);
  add(2, {kAskedOfCoverage}, gatherer);
  const Portrait portrait = gatherer.portrait();
  ASSERT_TRUE(portrait.coverage);
  EXPECT_EQ(portrait.coverage->hypothesis, kCornerOfWhole);
  EXPECT_EQ(sentences_of(portrait),
            std::vector<std::string>{
                "It cuts vertices to whole pixels and samples pixels at their lower left corner: "
                "that explains 9 of the 11 answers that cover something else."});
}

TEST(Portrait, PrefersFewerPartsWhereTheyExplainNearlyAsMuch) {
  PortraitGatherer gatherer;
  add(39, {kCorner, kCornerOfWhole, kAskedOfCoverage}, gatherer);
  add(1, {kCornerOfWhole, kAskedOfCoverage}, gatherer);
  EXPECT_EQ(gatherer.portrait().coverage->hypothesis, kCorner);
}

TEST(Portrait, HasNoFindingOfAFewAnswersOrOfAnOpenChoice) {
  PortraitGatherer few;
  add(4, {kCornerOfWhole, kAskedOfCoverage}, few);
  EXPECT_FALSE(few.portrait().coverage);
  PortraitGatherer open;
  add(9, {kOwnGrid, kAskedOfCoverage}, open);
  EXPECT_FALSE(open.portrait().coverage);
}

TEST(Portrait, OfOnePartTakesThreeAnswersIfTheyAreAll) {
  const auto finds = [](int explained, int others) {
    PortraitGatherer gatherer;
    add(explained, {kCorner, kAskedOfCoverage}, gatherer);
    add(others, {kAskedOfCoverage}, gatherer);
    return gatherer.portrait().coverage.has_value();
  };
  EXPECT_TRUE(finds(3, 0));
  EXPECT_FALSE(finds(4, 1));
  EXPECT_FALSE(finds(2, 0));
}

TEST(Portrait, LeavesToTheCatalogueWhatItExplainsBetter) {
  const auto finds = [](int by_one) {
    PortraitGatherer gatherer;
    add(10, {kCorner, kAskedOfCoverage, kHasOneCause}, gatherer);
    add(by_one, {kAskedOfCoverage, kHasOneCause}, gatherer);
    add(1, {kAskedOfCoverage}, gatherer);
    return gatherer.portrait().coverage.has_value();
  };
  EXPECT_TRUE(finds(0));
  EXPECT_FALSE(finds(9));
}

// What explains half of the differences of a driver that rarely differs does so by chance; of one
// that mostly differs it is a finding, and so is what explains nearly all.
TEST(Portrait, AsksForMoreWhereFewAnswersDiffer) {
  const auto finds = [](int explained, int others, int right) {
    PortraitGatherer gatherer;
    add(explained, {kCorner, kAskedOfCoverage}, gatherer);
    add(others, {kAskedOfCoverage}, gatherer);
    add(right, {}, gatherer);
    return gatherer.portrait().coverage.has_value();
  };
  EXPECT_FALSE(finds(10, 10, 100));
  EXPECT_TRUE(finds(10, 10, 60));
  EXPECT_FALSE(finds(10, 21, 0));
  EXPECT_TRUE(finds(10, 1, 1000));
}

TEST(Portrait, AsksColoursByThemselves) {
  PortraitGatherer gatherer;
  add(50, {kAskedOfCoverage}, gatherer);
  add(8, {kExchanged, kAskedOfColors}, gatherer);
  const Portrait portrait = gatherer.portrait();
  EXPECT_FALSE(portrait.coverage);
  ASSERT_TRUE(portrait.colors);
  ResultOutline answer;
  EXPECT_EQ(portrait.cause_of(answer), "");
  answer.standing = Standing::unexpected;
  answer.hypotheses = {{kExchanged, kExchanged}, {kAskedOfColors, kAskedOfColors}};
  EXPECT_EQ(portrait.cause_of(answer), "exchanges red and blue");
  answer.standing = Standing::known;
  EXPECT_EQ(portrait.cause_of(answer), "");
  EXPECT_EQ(sentences_of(portrait),
            std::vector<std::string>{
                "It exchanges red and blue: that explains 8 of the 8 answers that cover what they "
                "should in other colours."});
}

}  // namespace
}  // namespace edgecase
