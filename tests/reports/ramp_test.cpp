// SPDX-License-Identifier: MIT
#include "reports/ramp.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "tests/reports/sample.h"
#include "tests/reports/shown.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

using nlohmann::json;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Ramp = std::vector<Result::LevelPoint>;

// Points in a row, each exactly at level 1 in a band of half a level to both sides.
Ramp ramp_of(const std::vector<double>& rendered) {
  Ramp ramp;
  for (const double level : rendered)
    ramp.push_back({static_cast<int>(ramp.size()), 0, 1, 0.5, 1.5, level});
  return ramp;
}

std::string words_for(const Ramp& ramp) {
  return describe(summarize_ramp(ramp));
}

TEST(Ramp, TheFarthestFromExactInsideTheBand) {
  const RampSummary summary = summarize_ramp(ramp_of({1, 0.75, 1.0859375, 1.25, 1}));
  EXPECT_EQ(summary.fragments, 5U);
  EXPECT_EQ(summary.from_exact, 0.25);
  EXPECT_EQ(summary.from_band, 0);
  EXPECT_EQ(summary.farthest, 1U) << "the first of two";
  EXPECT_TRUE(summary.outside.empty());
  EXPECT_EQ(describe(summary), "At most 0.25 of a level from exact, inside the permitted band.");
}

TEST(Ramp, OutsideTheBandIsCountedAndMeasuredFromItsEnds) {
  const RampSummary summary = summarize_ramp(ramp_of({1, 0.25, 1.5, 3.625, 0.5}));
  EXPECT_EQ(summary.outside, (std::vector<std::size_t>{1, 3})) << "the ends are inside";
  EXPECT_EQ(summary.from_band, 2.125);
  EXPECT_EQ(summary.from_exact, 2.625);
  EXPECT_EQ(summary.farthest, 3U);
  EXPECT_EQ(describe(summary),
            "At most 2.62 levels from exact; outside the permitted band at 2 of 5 fragments, by at "
            "most 2.12 levels.");
}

TEST(Ramp, EqualIsSaidToBeEqual) {
  EXPECT_EQ(words_for(ramp_of({1, 1})),
            "Equal to exact at all 2 fragments, inside the permitted band.");
  EXPECT_EQ(words_for(ramp_of({1})),
            "Equal to exact at the only fragment, inside the permitted band.");
  EXPECT_FALSE(summarize_ramp(ramp_of({1, 1})).farthest);
}

TEST(Ramp, OneLevelIsALevel) {
  Ramp ramp = ramp_of({2});
  ramp[0].high = 2;
  EXPECT_EQ(words_for(ramp), "At most 1 level from exact, inside the permitted band.");
  ramp[0].rendered = 1.9999;
  EXPECT_EQ(words_for(ramp), "At most 1 level from exact, inside the permitted band.");
}

// A renderer has float32: what rounds to the same number is the same.
TEST(Ramp, NumbersAreComparedAsFloats) {
  const double third = 1.0 / 3;
  const Ramp ramp = {{0, 0, third, third, third, static_cast<double>(1.0F / 3)}};
  const RampSummary summary = summarize_ramp(ramp);
  EXPECT_EQ(summary.from_exact, 0);
  EXPECT_FALSE(summary.farthest);
  EXPECT_TRUE(summary.outside.empty());
  const Ramp next = {{0, 0, third, third, third, 0x1.555558p-2}};
  EXPECT_EQ(summarize_ramp(next).from_exact, 0x1p-25);
  EXPECT_EQ(summarize_ramp(next).outside.size(), 1U);
}

TEST(Ramp, EqualInfinitiesAreNoDistanceApart) {
  const Ramp ramp = {{0, 0, -kInfinity, -kInfinity, -kInfinity, -kInfinity},
                     {1, 0, 1, 0.5, 1.5, 1.25}};
  EXPECT_EQ(words_for(ramp), "At most 0.25 of a level from exact, inside the permitted band.");
}

TEST(Ramp, InfinitelyFarIsInNoDistance) {
  Ramp ramp = ramp_of({1.25, kInfinity, 1});
  EXPECT_EQ(words_for(ramp),
            "Infinitely far from exact at 1 of 3 fragments, elsewhere at most 0.25 of a level from "
            "exact; outside the permitted band at 1 of 3 fragments.");
  EXPECT_EQ(summarize_ramp(ramp).farthest, 1U);
  ramp[1] = {1, 0, -kInfinity, -kInfinity, 0, -126};
  EXPECT_EQ(words_for(ramp),
            "Infinitely far from exact at 1 of 3 fragments, elsewhere at most 0.25 of a level from "
            "exact, inside the permitted band.");
}

TEST(Ramp, NotANumberIsOutsideAndTheFarthest) {
  const RampSummary summary = summarize_ramp(ramp_of({1, kInfinity, kNaN, -kInfinity, kNaN}));
  EXPECT_EQ(summary.not_numbers, 2U);
  EXPECT_EQ(summary.infinitely_far, 2U);
  EXPECT_EQ(summary.farthest, 2U);
  EXPECT_EQ(summary.outside, (std::vector<std::size_t>{1, 2, 3, 4}));
  EXPECT_EQ(describe(summary),
            "Not a number at 2 of 5 fragments, infinitely far from exact at 2 of 5 fragments, "
            "elsewhere equal to exact; outside the permitted band at 4 of 5 fragments.");
  EXPECT_EQ(words_for(ramp_of({kNaN})),
            "Not a number at the only fragment; outside the permitted band at the only fragment.");
}

TEST(Ramp, WhereExactHasNoNumberNothingIsMeasured) {
  Ramp ramp = ramp_of({1, 1.25});
  ramp[0] = {0, 0, kNaN, -kInfinity, kInfinity, 7};
  EXPECT_EQ(words_for(ramp),
            "At most 0.25 of a level from exact, exact has no number at 1 of 2 fragments, inside "
            "the permitted band.");
  ramp.pop_back();
  EXPECT_EQ(words_for(ramp), "Exact has no number, inside the permitted band.");
}

json answer_for(const Ramp& ramp) {
  CaseResults one;
  one.results.resize(1);
  one.results[0].ramp = ramp;
  return sample::details_of(one)["answers"][0];
}

TEST(Ramp, TheReportHoldsItAsFloats) {
  Ramp ramp = ramp_of({1.1, kNaN});
  ramp[1].low = -kInfinity;
  ramp[1].high = 1.0 / 3;
  const json shown = answer_for(ramp)["ramp"];
  EXPECT_EQ(shown["points"].dump(),
            R"([[0,0,1,0.5,1.5,1.1],[1,0,1,"-Infinity",0.33333334,"NaN"]])");
  EXPECT_EQ(shown["outside"], json::array({1}));
  EXPECT_EQ(shown["farthest"], 1);
  EXPECT_EQ(shown["words"], words_for(ramp));
}

TEST(Ramp, AnAnswerWithoutOneHoldsNone) {
  EXPECT_FALSE(answer_for({}).contains("ramp"));
  EXPECT_FALSE(answer_for(ramp_of({1}))["ramp"].contains("farthest"));
}

TEST(Ramp, OutsideTheBandNamesTheOpenAlternative) {
  ValueAggregate levels;
  levels.ruling = 19;
  ValueAggregate followed = levels;
  followed.cause = cause_named("texture.log2=mantissa-8");
  ValueAggregate other;
  other.ruling = 24;
  other.cause = cause_named("texture.level-weight=floor-8");
  Result result;
  result.values = {levels, followed, other, followed};
  EXPECT_EQ(open_causes_of_levels(result), std::vector<std::string>{"texture.log2=mantissa-8"});
  result.disagreements.emplace_back().ruling = 24;
  EXPECT_EQ(open_causes_of_levels(result).size(), 1U) << "the colour's fault, not the level's";
  result.disagreements.emplace_back().ruling = 19;
  EXPECT_TRUE(open_causes_of_levels(result).empty()) << "a violation is no open choice";
}

TEST(Ramp, TheReportHoldsCausesWhereTheBandIsLeft) {
  EXPECT_EQ(answer_for(ramp_of({2}))["ramp"]["causes"], json::array());
  EXPECT_FALSE(answer_for(ramp_of({1}))["ramp"].contains("causes"));
}

// Renderers whose pictures are alike but whose levels are not do not share an answer.
TEST(Ramp, AnswersDifferByTheirLevels) {
  int ramps = 0;
  for (const CaseResults& one : sample::ramp_cases()) {
    const json shown = sample::details_of(one);
    for (std::size_t i = 0; i < one.results.size(); ++i) {
      const json& answer = shown["answers"][shown["results"][i]["answer"].get<std::size_t>()];
      ASSERT_EQ(answer.contains("ramp"), !one.results[i].ramp.empty());
      if (one.results[i].ramp.empty()) continue;
      ++ramps;
      EXPECT_EQ(answer["ramp"]["words"], words_for(one.results[i].ramp));
    }
  }
  EXPECT_EQ(ramps, 11);
}

}  // namespace
}  // namespace edgecase
