// SPDX-License-Identifier: MIT
//
// Things that are one in all answers: whoever shows two of one is told so, by the name of the other
// answer, and nobody else is.
#include "diff/single_things.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "diff/findings/most_meet.h"
#include "diff/judge.h"

namespace edgecase {
namespace {

constexpr SingleThing kUnit{SingleThing::Kind::offset_unit, 16, 0};
constexpr SingleThing kPlace{SingleThing::Kind::sample_x, 4, 2};

Result showing(SingleThing thing, double low, double high) {
  Result result;
  result.shown = {{thing, low, high}};
  return result;
}

// A pixel that keeps a sample of an alpha of 0.3 keeps it of 0.5.
TEST(SingleThings, WhatAPixelKeepsNeverFallsAsAlphaGrows) {
  const SingleThing first{SingleThing::Kind::alpha, 4, 2, 3, 1};
  const SingleThing other{SingleThing::Kind::alpha, 4, 2, 4, 1};
  Result keeps = showing(first, 0, 0.3), loses = showing(first, 0.5, 1);
  Result elsewhere = showing(other, 0.5, 1), same = showing(first, 0.3, 1);
  RunReader reader;
  Result* const all[] = {&keeps, &loses, &elsewhere, &same};
  for (std::size_t i = 0; i < std::size(all); ++i) reader.add(*all[i], std::string(1, "abcd"[i]));
  judge(all, Latitude::opengl, reader.reading());
  EXPECT_EQ(std::ranges::count(all, Verdict::agree, &Result::verdict), 3);
  EXPECT_EQ(loses.verdict, Verdict::contested);
  ASSERT_EQ(loses.disagreements.size(), 1u);
  EXPECT_EQ(loses.disagreements[0].x, 3);
  EXPECT_EQ(loses.disagreements[0].rule, RuleId::sample_alpha_to_coverage);
  EXPECT_EQ(loses.disagreements[0].explanation,
            "the least alpha of which pixel (3, 1) keeps 2 of 4 samples is at least 0.5 by this "
            "answer, and at most 0.3 by that to a: both cannot be, since it is one. Ruling 69");
}

TEST(SingleThings, MostIntervalsMeetInOne) {
  EXPECT_FALSE(where_most_meet({}));
  const auto where = where_most_meet({{{0, 2}}, {{1, 3}}, {{5, 6}}});
  ASSERT_TRUE(where);
  EXPECT_EQ(std::pair(where->low, where->high), std::pair(1.0, 2.0));
  const auto heavy = where_most_meet({{{0, 2}}, {{1, 3}}, {{5, 6}, 3}});
  ASSERT_TRUE(heavy);
  EXPECT_EQ(heavy->low, 5);
  const auto touching = where_most_meet({{{0, 1}}, {{1, 2}}});
  ASSERT_TRUE(touching);
  EXPECT_EQ(std::pair(touching->low, touching->high), std::pair(1.0, 1.0));
}

// By every number that some interval begins or ends with.
TEST(SingleThings, MostIntervalsMeetWhereTheyAreCountedToMeet) {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    std::vector<Weighed> all;
    for (auto n = 1 + random() % 6; n > 0; --n) {
      const auto low = static_cast<double>(random() % 10);
      all.push_back({{low, low + static_cast<double>(random() % 5)}, 1 + random() % 3});
    }
    const auto weight_at = [&](double at) {
      std::size_t weight = 0;
      for (const auto& [interval, own] : all) weight += interval.contains(at) ? own : 0;
      return weight;
    };
    std::size_t most = 0;
    for (const auto& [interval, own] : all) most = std::max(most, weight_at(interval.low));
    const auto where = where_most_meet(all);
    ASSERT_TRUE(where);
    EXPECT_EQ(weight_at(where->low), most);
    EXPECT_EQ(weight_at(where->high), most);
  }
}

TEST(SingleThings, WhoShowsAnotherThingThanMostIsToldByWhom) {
  Result a = showing(kUnit, 1, 2), b = showing(kUnit, 1.5, 3), c = showing(kUnit, 4, 5);
  RunReader reader;
  reader.add(a, "a");
  reader.add(b, "b");
  reader.add(c, "c");
  const RunReading reading = reader.reading();
  Result* const all[] = {&a, &b, &c};
  for (int time = 0; time < 2; ++time) {  // judging twice changes nothing
    judge(all, Latitude::opengl, reading);
    EXPECT_EQ(a.verdict, Verdict::agree);
    EXPECT_EQ(b.verdict, Verdict::agree);
    EXPECT_EQ(c.verdict, Verdict::violation);
    ASSERT_EQ(c.disagreements.size(), 1u);
    EXPECT_EQ(c.disagreements[0].rule, RuleId::offset_unit);
    EXPECT_NE(c.disagreements[0].explanation.find("at most 2 by that to a:"), std::string::npos)
        << c.disagreements[0].explanation;
  }
  judge(all, Latitude::opengl, {});
  EXPECT_EQ(c.verdict, Verdict::agree);
}

TEST(SingleThings, WhatMeetsIsNotTold) {
  SingleThings things;
  things.add(showing(kUnit, 1, 2), "a");
  things.add(showing(kUnit, 2, 3), "b");
  things.add(showing(kPlace, 7, 8), "c");  // another thing
  things.add(showing({SingleThing::Kind::sample_x, 8, 2}, 0, 1), "d");
  const auto refuted = [&] {
    return std::ranges::count_if(things.meetings(),
                                 [](const auto& one) { return one.second.is_refuted; });
  };
  EXPECT_EQ(refuted(), 0);
  things.add(showing(kPlace, 5, 6), "e");
  EXPECT_EQ(refuted(), 1);
}

// A ring of cells round the place that others show: its box holds that place, none of its cells
// does.
TEST(SingleThings, CellsThatNowhereMeetTheOtherAnswersAreRefuted) {
  const auto x = showing({SingleThing::Kind::sample_x, 4, 2}, 0.375, 0.4375);
  const auto y = showing({SingleThing::Kind::sample_y, 4, 2}, 0.5, 0.5625);
  const SingleThing thing{SingleThing::Kind::sample_cells, 4, 2};
  PlaceCells cells;
  for (const double at : {0.03, 0.97}) cells.add(at, at);
  Result ring;
  ring.shown = {{thing, 0, 0, cells}};
  cells.add(0.46, 0.51);  // the cell to the right has a border in common
  Result near;
  near.shown = {{thing, 0, 0, cells}};
  RunReader reader;
  reader.add(x, "x");
  reader.add(y, "y");
  const RunReading reading = reader.reading();
  Result* const both[] = {&ring, &near};
  judge(both, Latitude::opengl, reading);
  EXPECT_EQ(ring.verdict, Verdict::violation);
  EXPECT_EQ(near.verdict, Verdict::agree);
  const auto again = PlaceCells::parse(cells.text());
  ASSERT_TRUE(again);
  EXPECT_EQ(*again, cells);
  EXPECT_FALSE(PlaceCells::parse("0"));
}

TEST(SingleThings, ThePortraitHoldsThem) {
  SingleThings things;
  things.add(showing(kUnit, 1.5e-5, 1.6e-5), "a");
  things.add(showing(kPlace, 0.25, 0.5), "a");
  things.add(showing({SingleThing::Kind::sample_y, 4, 2}, 0.75, 1), "b");
  const std::map<std::string, std::string> expected = {
      {"place of sample 2 of 4", "(0.25, 0.75) to (0.5, 1)"},
      {"unit of polygon offset, 16 bits", "1.5e-05 to 1.6e-05"}};
  EXPECT_EQ(traits_of(things.meetings()), expected);
  for (const auto& [name, value] : expected) EXPECT_TRUE(is_of_a_thing(name + ", fbo"));
  EXPECT_FALSE(is_of_a_thing("point_sizes"));
}

// The order in which threads come does not matter.
TEST(SingleThings, TheOrderOfAnswersDoesNotMatter) {
  std::vector<std::pair<Result, std::string>> answers;
  for (int i = 0; i < 6; ++i)
    answers.emplace_back(showing(kUnit, i % 3, i % 3 + 1.5), std::to_string(9 - i));
  std::optional<Meeting> first;
  std::mt19937 random(2);
  for (int time = 0; time < 20; ++time) {
    std::shuffle(answers.begin(), answers.end(), random);
    SingleThings things;
    for (const auto& [result, id] : answers) things.add(result, id);
    const Meeting meeting = things.meetings().at(kUnit);
    if (!first) first = meeting;
    EXPECT_EQ(meeting.lowest, first->lowest);
    EXPECT_EQ(meeting.highest, first->highest);
    EXPECT_EQ(meeting.where.low, first->where.low);
  }
}

}  // namespace
}  // namespace edgecase
