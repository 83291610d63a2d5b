// SPDX-License-Identifier: MIT
//
// Resolved pixels of renderers that do not tell their samples.
#include <gtest/gtest.h>

#include <algorithm>

#include "raster/rasterizer.h"
#include "tests/diff/samples/sample_judging.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

Rendering without_samples(Rendering rendering) {
  rendering.sample_pixels.clear();
  return rendering;
}

TEST(UnreportedSamples, AreInferredFromFragments) {
  for (const bool alpha : {false, true}) {
    Scene scene = partly_covered();
    scene.draws.front().multisampling.alpha_to_coverage = alpha;
    Rendering rendering = without_samples(rasterize(scene, {}));
    EXPECT_EQ(judged(scene, rendering).verdict, Verdict::agree);
    rendering.hits.clear();
    EXPECT_EQ(judged(scene, rendering).disagreements.size(), 0U);
    for (Fragment& fragment : rendering.fragments) fragment.has_color = false;
    EXPECT_EQ(judged(scene, rendering).disagreements.size(), 0U);
  }
}

TEST(UnreportedSamples, ATruncatingResolveOfUnreportedSamplesIsAConvention) {
  const Scene scene = partly_covered();
  const Result result =
      judged(scene, without_samples(rendered_with(scene, "sample.resolve", "truncated")));
  EXPECT_EQ(result.verdict, Verdict::convention);
  EXPECT_EQ(causes_of(result), std::set<std::string>{"sample.resolve=truncated"});
}

TEST(UnreportedSamples, AResolveBeyondUnreportedSamplesIsAViolation) {
  const Scene scene = partly_covered();
  const Rendering right = without_samples(rasterize(scene, {}));
  // Of pixels that no fragment covers, that one fragment covers in part, and that it covers wholly.
  const auto pixel_of = [&](std::uint32_t coverage) {
    const Fragment& f = *std::ranges::find_if(
        right.fragments, [&](const Fragment& each) { return each.coverage == coverage; });
    return right.pixel_index(f.x, f.y);
  };
  for (const std::size_t pixel : {std::size_t{0}, pixel_of(1), pixel_of(15)}) {
    Rendering rendering = right;
    rendering.pixels[4 * pixel + 3] = 0;
    const Result result = judged(scene, rendering);
    EXPECT_EQ(result.verdict, Verdict::violation);
    EXPECT_EQ(rules_of(result), std::set<std::string>{"sample.resolve"});
    EXPECT_EQ(result.disagreements.size(), 1U);
  }
}

// What hits say of samples decides which of the fragments' colours a pixel is the mean of.
TEST(UnreportedSamples, HitsTellWhichSamplesAlphaHasLeft) {
  Scene scene = partly_covered();
  scene.draws.front().multisampling.alpha_to_coverage = true;
  const Rendering drawn = rasterize(scene, {});
  const Rendering all_written =
      rasterize(scene, policy_with("sample.alpha-to-coverage", "ignored"));
  Rendering rendering = without_samples(drawn);
  rendering.pixels = all_written.pixels;
  const auto differing = [&] {
    const Result result = judged(scene, rendering);
    EXPECT_EQ(result.disagreements.size(), 0U);
    std::size_t pixels = 0;
    for (const ValueAggregate& values : result.values)
      if (values.rule == "sample.resolve") pixels += values.differing.size();
    return pixels;
  };
  // With hits the pixels are no means of what they left, which is legal near its range; without
  // them they may be.
  const std::size_t contradicted = differing();
  EXPECT_GT(contradicted, 0U);
  const Result nothing = judged(scene, without_samples(drawn));
  EXPECT_EQ(nothing.values.size() + nothing.disagreements.size(), 0U);
}

TEST(UnreportedSamples, AlphasOfZeroAndOneAreHeededWithoutHits) {
  Scene scene = partly_covered();
  scene.draws.front().multisampling.alpha_to_coverage = true;
  for (Vertex& vertex : scene.draws.front().vertices) vertex.color[3] = 0;
  const Rendering right = rasterize(scene, {});
  Rendering written = rendered_with(scene, "sample.alpha-to-coverage", "ignored");
  for (const bool reported : {false, true}) {
    Rendering rendering = reported ? written : without_samples(written);
    rendering.hits.clear();
    const Result result = judged(scene, rendering);
    EXPECT_EQ(result.verdict, Verdict::violation);
    EXPECT_EQ(rules_of(result), std::set<std::string>{"sample.alpha-to-coverage"});
    rendering.pixels = right.pixels;
    if (reported) rendering.sample_pixels = right.sample_pixels;
    EXPECT_EQ(judged(scene, rendering).verdict, Verdict::agree);
  }
}

}  // namespace
}  // namespace edgecase
