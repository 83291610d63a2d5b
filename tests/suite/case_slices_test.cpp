// SPDX-License-Identifier: MIT
#include "suite/case_store.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace edgecase {
namespace {

Case case_of(int width, int height, int samples = 1) {
  Case one;
  one.scene.target.width = width;
  one.scene.target.height = height;
  one.scene.target.samples = samples;
  return one;
}

using Slices = std::vector<std::pair<std::size_t, std::size_t>>;

Slices slices_of(const std::vector<Case>& cases, SliceLimits most) {
  Slices slices;
  for (const CaseSlice& slice : cut_cases(cases, most)) slices.emplace_back(slice.begin, slice.end);
  return slices;
}

TEST(CaseSlices, NoCaseNoSlice) {
  EXPECT_TRUE(cut_cases({}, {1000}).empty());
}

TEST(CaseSlices, ASliceIsFullWhenTheNextCaseWouldMakeItTooHeavy) {
  const std::vector<Case> cases(5, case_of(8, 8));  // 64 samples and 256 each
  EXPECT_EQ(slices_of(cases, {640}), (Slices{{0, 2}, {2, 4}, {4, 5}}));
  EXPECT_EQ(slices_of(cases, {639}), (Slices{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}}));
  EXPECT_EQ(slices_of(cases, {5 * 320}), (Slices{{0, 5}}));
}

// Small cases cost as much as what is done for each case.
TEST(CaseSlices, ASliceHasSoManyCasesAtMost) {
  const std::vector<Case> cases(5, case_of(1, 1));
  EXPECT_EQ(slices_of(cases, {1000000, 2}), (Slices{{0, 2}, {2, 4}, {4, 5}}));
  EXPECT_EQ(slices_of(cases, {1000000, 1}), (Slices{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}}));
  EXPECT_EQ(slices_of(cases, {2 * 257, 3}), (Slices{{0, 2}, {2, 4}, {4, 5}}));
}

TEST(CaseSlices, ACaseThatIsTooHeavyHasASliceOfItsOwn) {
  const std::vector<Case> cases{case_of(8, 8), case_of(512, 512), case_of(8, 8)};
  EXPECT_EQ(slices_of(cases, {1000}), (Slices{{0, 1}, {1, 2}, {2, 3}}));
}

TEST(CaseSlices, SamplesAndPassesWeigh) {
  EXPECT_EQ(slices_of({case_of(8, 8), case_of(8, 8, 4)}, {2 * 320}), (Slices{{0, 1}, {1, 2}}));
  Case supersampled = case_of(8, 8);
  supersampled.scene.supersampling.resize(2);
  EXPECT_EQ(slices_of({case_of(8, 8), supersampled}, {2 * 320}), (Slices{{0, 1}, {1, 2}}));
}

}  // namespace
}  // namespace edgecase
