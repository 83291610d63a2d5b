// SPDX-License-Identifier: MIT
//
// Each pixel counts once, by the worst that was found at it.
#include "diff/verdicts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "diff/compare.h"
#include "raster/rasterizer.h"
#include "tests/diff/named_scenes.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/judging.h"

namespace edgecase {
namespace {

constexpr const char* kOpen = "triangle.fill-rule=left-bottom";

Disagreement disagreement_at(int x, int y, bool legal, const char* cause) {
  Disagreement d;
  d.x = x;
  d.y = y;
  d.legality = by_letter(legal);
  d.cause = cause_named(cause);
  return d;
}

ValueAggregate values_at(std::vector<ValueAggregate::Place> places, const char* cause) {
  ValueAggregate values;
  values.differing = std::move(places);
  values.cause = cause_named(cause);
  return values;
}

// Of a picture of so many pixels.
PixelCounts counted(Result result, std::size_t pixels, Latitude latitude = Latitude::opengl) {
  result.pixel_counts[Verdict::agree] = pixels;
  count_pixels(result, latitude);
  return result.pixel_counts;
}

Verdict worst_of(const PixelCounts& counts) {
  Verdict worst = Verdict::agree;
  for (const Verdict verdict : kDrawnVerdicts)
    if (counts[verdict] > 0) worst = verdict;
  return worst;
}

TEST(PixelCounts, CountEachPixelByItsWorst) {
  Result result;
  result.pixel_counts.same = 5;
  EXPECT_EQ(counted(result, 16), (PixelCounts{{16, 0, 0, 0, 0}, 5}));
  result.disagreements = {disagreement_at(1, 0, true, kOpen), disagreement_at(1, 0, true, kOpen),
                          disagreement_at(2, 0, true, ""),
                          disagreement_at(3, 0, true, "triangle.fill-rule=open")};
  EXPECT_EQ(counted(result, 16), (PixelCounts{{13, 1, 2, 0, 0}, 5}));
  // x and y are not mistaken for each other.
  result.disagreements.push_back(disagreement_at(0, 1, false, kOpen));
  EXPECT_EQ(counted(result, 16), (PixelCounts{{12, 1, 2, 0, 1}, 5}));
  result.values = {values_at({{1, 0, 4}, {2, 0, 4}, {5, 0, 4}, {5, 0, 6}}, ""),
                   values_at({{0, 1, 4}, {6, 0, 4}}, "texture.log2=mantissa-8")};
  EXPECT_EQ(counted(result, 16), (PixelCounts{{10, 1, 4, 0, 1}, 5}));
  EXPECT_EQ(counted(result, 16, Latitude::none), (PixelCounts{{10, 0, 0, 0, 6}, 5}));
}

TEST(PixelCounts, AreZeroWithoutAPicture) {
  Result result;
  result.disagreements = {disagreement_at(1, 0, false, "")};
  EXPECT_EQ(counted(result, 0), PixelCounts{});
}

// Of random scenes drawn by other rules: what a pixel counts as is what the case is, for the worst
// of them; and a pixel without any finding has exact's colour.
TEST(PixelCounts, HaveTheVerdictOfTheirCaseAsTheirWorst) {
  RandomScenes random(41);
  std::set<Verdict> seen;
  for (int i = 0; i < 300; ++i) {
    const Scene scene = random.next({10, Fixed::kOne / 8, 3, true});
    Policy policy;
    policy.rules["triangle.fill-rule"] = i % 3 == 0 ? "open" : "left-bottom";
    if (i % 4 == 0) policy.rules["triangle.snap"] = "4-half-even";
    const Rendering exact = rasterize(scene, {});
    const Rendering rendered = rasterize(scene, i % 10 == 0 ? Policy{} : policy);
    const Result result = judged(scene, rendered);
    const PixelCounts& counts = result.pixel_counts;
    EXPECT_EQ(worst_of(counts), result.verdict) << i;
    EXPECT_EQ(counts.all(), 100u);
    std::size_t same = 0;
    for (std::size_t p = 0; p < 100; ++p)
      same += std::equal(&exact.pixels[4 * p], &exact.pixels[4 * p] + 4, &rendered.pixels[4 * p]);
    EXPECT_EQ(counts.same, same);
    EXPECT_GE(counts.same, counts[Verdict::agree]);
    seen.insert(result.verdict);
  }
  EXPECT_GE(seen.size(), 2u);
}

}  // namespace
}  // namespace edgecase
