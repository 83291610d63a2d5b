// SPDX-License-Identifier: MIT
#include "run/comparing.h"

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <optional>

#include "diff/findings/patience.h"
#include "raster/rasterizer.h"

namespace edgecase {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// A suite of one case: a triangle in a target of so many samples.
Suite suite_of(int samples) {
  Case one;
  one.id = "triangle";
  one.scene.target.width = one.scene.target.height = 8;
  one.scene.target.samples = samples;
  one.scene.viewport = {0, 0, 8, 8};
  Draw draw;
  draw.primitive = Primitive::triangles;
  for (const auto& [x, y] : {std::pair{1, 1}, {7, 2}, {3, 7}}) {
    Vertex vertex;
    vertex.position = {Fixed::from_integer(x), Fixed::from_integer(y)};
    vertex.color = {1, 0.5F, 0.25F, 1};
    draw.vertices.push_back(vertex);
  }
  one.scene.draws = {draw};
  Suite suite;
  suite.cases = {one};
  return suite;
}

TEST(CaseComparison, KeepsAPictureOnceThatExactDrawsToo) {
  for (const int samples : {1, 4}) {
    const Suite suite = suite_of(samples);
    const RunOptions options;
    const Case asked = suite.cases[0];
    CaseComparison comparison(suite.cases.size(), options);
    const Rendering same = rasterize(asked.scene, options.policy);
    const Result result = comparison.compare_outcome(0, asked, same, {});
    EXPECT_EQ(result.pixels->bytes(), same.pixels);
    const ExactSide& exact = comparison.exact(0, asked.scene);
    EXPECT_TRUE(is_same_object(result.pixels, exact.pixels));
    EXPECT_EQ(result.samples, sample_image(same));
    EXPECT_TRUE(is_same_object(result.samples.pixels, exact.samples.pixels));
    EXPECT_TRUE(is_same_object(result.samples.hits, exact.samples.hits));
    EXPECT_TRUE(is_same_object(result.samples.coverage, exact.samples.coverage));
  }
}

TEST(CaseComparison, KeepsWhatDiffersAsItCame) {
  const Suite suite = suite_of(4);
  const RunOptions options;
  const Case asked = suite.cases[0];
  CaseComparison comparison(suite.cases.size(), options);
  Rendering other = rasterize(asked.scene, options.policy);
  other.pixels.back() ^= 1;
  other.sample_pixels.back() ^= 1;
  const Result result = comparison.compare_outcome(0, asked, other, {});
  EXPECT_EQ(result.pixels->bytes(), other.pixels);
  EXPECT_EQ(result.samples.pixels->bytes(), other.sample_pixels);
  const ExactSide& exact = comparison.exact(0, asked.scene);
  EXPECT_NE(result.pixels, exact.pixels);
  EXPECT_NE(result.samples.pixels, exact.samples.pixels);
  EXPECT_TRUE(is_same_object(result.samples.hits, exact.samples.hits));
}

// A renderer whose samples lie elsewhere shares with the exact side that it was held against.
TEST(CaseComparison, SharesWithExactWhereTheSamplesAreTheRenderers) {
  const Suite suite = suite_of(4);
  const RunOptions options;
  const Case asked = suite.cases[0];
  CaseComparison comparison(suite.cases.size(), options);
  SamplePositions elsewhere = comparison.exact(0, asked.scene).rendering.sample_positions;
  for (Point& at : elsewhere) at.x = Fixed::from_integer(1) - at.x;
  const Rendering drawn = rasterize_for_comparison(asked.scene, options.policy, elsewhere);
  const Result result = comparison.compare_outcome(0, asked, drawn, {});
  EXPECT_TRUE(result.disagreements.empty());
  EXPECT_EQ(result.exact_pixels->bytes(), drawn.pixels);
  EXPECT_TRUE(is_same_object(result.pixels, result.exact_pixels));
  EXPECT_TRUE(is_same_object(result.samples.coverage, result.exact_samples.coverage));
  EXPECT_NE(result.samples.coverage, comparison.exact(0, asked.scene).samples.coverage);
}

// The same case with a target for which there is no memory; no case file may ask for it.
Case without_memory(Case one) {
  one.id = "without-memory";
  one.scene.target.width = one.scene.target.height = 1 << 24;
  return one;
}

void expect_internal(const std::optional<Failure>& failure) {
  ASSERT_TRUE(failure.has_value());
  EXPECT_EQ(failure->kind, FailureKind::internal);
  EXPECT_THAT(failure->reason, AllOf(HasSubstr("without-memory"), HasSubstr("please report it")));
}

TEST(CaseComparison, TellsAFaultOfOursByTheCase) {
  const Suite suite = suite_of(1);
  const RunOptions options;
  const Case asked = suite.cases[0];
  CaseComparison comparison(suite.cases.size(), options);
  const Rendering right = rasterize(asked.scene, options.policy);
  const Result result = comparison.compare_outcome(0, without_memory(asked), right, {});
  EXPECT_EQ(result.verdict, Verdict::not_run);
  expect_internal(result.failure);
  EXPECT_FALSE(comparison.compare_outcome(0, asked, right, {}).failure);
}

TEST(RunSuite, LosesOnlyTheCaseInWhichItFails) {
  Suite suite = suite_of(1);
  suite.cases.push_back(without_memory(suite.cases[0]));
  suite.cases.sort_by_id();
  RunOptions options;
  options.renderers = {"exact"};
  const Results results = run_suite(suite, options).results;
  ASSERT_EQ(results.cases.size(), 2u);
  EXPECT_EQ(results.cases.outline(0).answers[0].verdict, Verdict::agree);
  expect_internal(results.cases.outline(1).answers[0].failure);
  EXPECT_EQ(results.cases.outline(1).expect_failures, 1u);
}

Rendering without_fragments(const Case& asked) {
  Rendering rendering = rasterize(asked.scene, Policy{});
  rendering.fragments.clear();
  return rendering;
}

TEST(CaseComparison, IsNotRunIfItTakesTooLongWhichIsNotTheRenderersFault) {
  const Suite suite = suite_of(1);
  RunOptions options;
  options.comparison_patience = std::chrono::milliseconds(-1);
  const Case asked = suite.cases[0];
  CaseComparison comparison(suite.cases.size(), options);
  const Result result = comparison.compare_outcome(0, asked, without_fragments(asked), {});
  EXPECT_EQ(result.verdict, Verdict::not_run);
  ASSERT_TRUE(result.failure.has_value());
  EXPECT_EQ(result.failure->kind, FailureKind::timed_out);
  EXPECT_NE(result.failure->reason.find("edgecase"), std::string::npos);
}

TEST(CaseComparison, EndsWithTheRun) {
  const Suite suite = suite_of(1);
  const std::atomic<bool> stop = true;
  RunOptions options;
  options.stop = &stop;
  const Case asked = suite.cases[0];
  CaseComparison comparison(suite.cases.size(), options);
  EXPECT_THROW(comparison.compare_outcome(0, asked, without_fragments(asked), {}),
               ComparisonStopped);
}

}  // namespace
}  // namespace edgecase
