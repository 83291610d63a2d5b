// SPDX-License-Identifier: MIT
//
// Errors inside what is permitted: how they are counted, and that the worst of them is named.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>

#include "diff/compare.h"
#include "diff/values/value_diff.h"
#include "raster/rasterizer.h"
#include "tests/diff/values/value_mutants.h"

namespace edgecase {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;

constexpr ValueAggregate::Place kHere{3, 4, 1};
constexpr ValueAggregate::Place kThere{5, 6, 2};

Result flushed(ValueAggregator& aggregator) {
  Result result;
  aggregator.flush(result);
  return result;
}

TEST(ValueAggregator, MeansAreOverAllComponentsThoseWithoutErrorToo) {
  ValueAggregator aggregator("color", RuleId::attribute_smooth, 9);
  for (int i = 0; i < 5; ++i) aggregator.count_compared(4);
  aggregator.add_error(kHere, {0, 0.5, 0.75, 3, 1});
  aggregator.add_error(kHere, {2, 0.5, 0.5, 1, 1});
  aggregator.add_place(kHere);
  aggregator.add_error(kThere, {1, 0.5, 0.25, 6, 1});
  aggregator.add_place(kThere);
  const Result result = flushed(aggregator);
  ASSERT_EQ(result.values.size(), 1u);
  const ValueAggregate& values = result.values[0];
  EXPECT_EQ(values.attribute, "color");
  EXPECT_EQ(values.rule, RuleId::attribute_smooth);
  EXPECT_EQ(values.ruling, 9);
  EXPECT_EQ(values.compared, 5u);
  EXPECT_EQ(values.components, 20u);
  EXPECT_EQ(values.differing.size(), 2u);
  EXPECT_EQ(values.mean_ulp, 0.5);
}

TEST(ValueAggregator, TheWorstIsTheLargestInUlpWhereverItComes) {
  for (const bool first : {true, false}) {
    ValueAggregator aggregator("depth", RuleId::fragment_depth, 9);
    aggregator.count_compared(1);
    aggregator.count_compared(1);
    if (first) aggregator.add_error(kThere, {0, 0.125, 0.25, 9, 0});
    aggregator.add_error(kHere, {0, 0.5, 0.625, 2, 0});
    if (!first) aggregator.add_error(kThere, {0, 0.125, 0.25, 9, 0});
    aggregator.add_place(kHere);
    aggregator.add_place(kThere);
    const ValueAggregate values = flushed(aggregator).values.at(0);
    EXPECT_EQ(values.worst.x, kThere.x);
    EXPECT_EQ(values.worst.y, kThere.y);
    EXPECT_EQ(values.worst.primitive, kThere.primitive);
    EXPECT_EQ(values.worst_exact, 0.125);
    EXPECT_EQ(values.worst_rendered, 0.25);
    EXPECT_EQ(values.worst_ulp, 9);
  }
}

// The largest share of the range need not be where the error in ULP is largest.
TEST(ValueAggregator, RelativeErrorsAreOfTheRangeAndOfTheirOwn) {
  ValueAggregator aggregator("color", RuleId::attribute_smooth, 9);
  aggregator.count_compared(4);
  aggregator.add_error(kHere, {0, 0, 1e-30, 1e9, 0.5});
  aggregator.add_error(kHere, {1, 1, 1.25, 4, 2});
  aggregator.add_error(kHere, {2, 1, 5, 2, 0});  // a constant: it has no range
  aggregator.add_place(kHere);
  const ValueAggregate values = flushed(aggregator).values.at(0);
  EXPECT_EQ(values.worst_relative, 0.125);
  EXPECT_EQ(values.worst_ulp, 1e9);
  EXPECT_EQ(values.worst_component, 0);
}

TEST(ValueAggregator, TheHistogramCountsComponentsByPowersOfTwo) {
  ValueAggregator aggregator("color", RuleId::attribute_smooth, 9);
  aggregator.count_compared(4);
  int component = 0;
  for (const double ulp : {0.25, 0.3, 1.0, 1.99, 2.0, 3.0, 1024.0, 0.0})
    aggregator.add_error(kHere, {component++ % 4, 1, 1, ulp, 1});
  aggregator.add_place(kHere);
  EXPECT_THAT(flushed(aggregator).values.at(0).ulp_histogram,
              ElementsAre(Pair(-1074, 1), Pair(-2, 2), Pair(0, 2), Pair(1, 2), Pair(10, 1)));
}

// Passes of one scene are added up before anything is left out.
TEST(ValueAggregator, ComparedValuesAreReportedThoughNothingDiffers) {
  ValueAggregator aggregator("color", RuleId::attribute_smooth, 9);
  EXPECT_TRUE(flushed(aggregator).values.empty());
  aggregator.count_compared(4);
  const Result result = flushed(aggregator);
  ASSERT_EQ(result.values.size(), 1u);
  EXPECT_EQ(result.values[0].compared, 1u);
  EXPECT_EQ(result.values[0].components, 4u);
  EXPECT_EQ(result.values[0].mean_ulp, 0);
}

TEST(FloatUlp, IsTheDistanceToTheNextNumber) {
  EXPECT_EQ(float_ulp(1), 0x1p-23);
  EXPECT_EQ(float_ulp(-1), 0x1p-23);
  EXPECT_EQ(float_ulp(0.75), 0x1p-24);
  EXPECT_EQ(float_ulp(0), 0x1p-149);
  EXPECT_EQ(float_ulp(0x1p-140), 0x1p-149);
  EXPECT_EQ(float_ulp(static_cast<double>(FLT_MAX)), 0x1p104);
}

// All colours one ULP off, one of them five: that one is named, with what it has and should have.
TEST(Aggregates, OneFragmentAmongManyIsNamed) {
  const Scene& scene = value_scene("linear triangle");
  const Rendering exact = rasterize(scene, {});
  Rendering wrong = exact;
  const std::size_t victim = wrong.fragments.size() / 3;
  for (std::size_t i = 0; i < wrong.fragments.size(); ++i)
    for (int times = 0; times < (i == victim ? 5 : 1); ++times)
      wrong.fragments[i].color[2] = float_above(wrong.fragments[i].color[2]);
  const Result result = compare(scene, {}, exact, wrong, {8});
  EXPECT_TRUE(result.disagreements.empty());
  ASSERT_EQ(result.values.size(), 1u);
  const ValueAggregate& color = result.values[0];
  const Fragment& f = exact.fragments[victim];
  EXPECT_EQ(color.worst.x, f.x);
  EXPECT_EQ(color.worst.y, f.y);
  EXPECT_EQ(color.worst_component, 2);
  EXPECT_EQ(color.worst_exact, f.color[2]);
  EXPECT_EQ(color.worst_rendered, wrong.fragments[victim].color[2]);
  EXPECT_GT(color.worst_ulp, 4);
  EXPECT_LT(color.worst_ulp, 6);
  EXPECT_EQ(color.compared, exact.fragments.size());
  EXPECT_EQ(color.components, 4 * exact.fragments.size());
  EXPECT_EQ(color.differing.size(), exact.fragments.size());
  // One of four components, by about one ULP; the range of blue is 0.7.
  EXPECT_GT(color.mean_ulp, 0.2);
  EXPECT_LT(color.mean_ulp, 0.3);
  EXPECT_NEAR(color.worst_relative, (color.worst_rendered - color.worst_exact) / 0.7, 1e-9);
  std::uint64_t counted = 0;
  for (const auto& [exponent, count] : color.ulp_histogram) counted += count;
  EXPECT_EQ(counted, exact.fragments.size());
}

// What is beyond the permitted is called by its name.
TEST(Components, HaveTheirNamesInSentences) {
  const Rendering exact = rasterize(value_scene("linear triangle"), {});
  const auto sentences = [&](auto change) {
    Rendering wrong = exact;
    change(wrong.fragments[0]);
    std::string all;
    for (const Disagreement& d :
         compare(value_scene("linear triangle"), {}, exact, wrong, {8}).disagreements)
      all += d.explanation + "\n";
    return all;
  };
  EXPECT_THAT(sentences([](Fragment& f) { f.color[0] = 7; }), HasSubstr("red of primitive 0 is "));
  EXPECT_THAT(sentences([](Fragment& f) { f.color[2] = 7; }), HasSubstr("blue of primitive 0 is "));
  EXPECT_THAT(sentences([](Fragment& f) { f.color[3] = 7; }), HasSubstr("alpha of primitive 0 "));
  EXPECT_THAT(sentences([](Fragment& f) { f.depth = 7; }), HasSubstr("depth of primitive 0 is "));
}

TEST(PermittedIntervals, AlwaysHoldWhatIsExact) {
  EXPECT_TRUE(holding({0.25, 0.5}, 0.375).contains(0.375));
  const Interval wider = holding({0.25, 0.5}, -1);
  EXPECT_EQ(wider.low, -1);
  EXPECT_EQ(wider.high, 0.5);
  // A number that is none is in no interval.
  EXPECT_EQ(holding({0.25, 0.5}, std::nan("")).low, 0.25);
}

}  // namespace
}  // namespace edgecase
