// SPDX-License-Identifier: MIT
//
// Fates of samples: rules on multisampled targets that show in what a depth test makes of their
// fragments, and samples that a renderer does not tell.
#include <gtest/gtest.h>

#include <algorithm>

#include "raster/rasterizer.h"
#include "tests/diff/output/output_judging.h"
#include "tests/raster/multisampled_scenes.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

using Names = std::set<std::string>;

// Two triangles that pass through each other, with four samples.
Scene crossing() {
  RandomPoints points(31);
  Scene scene = multisampled_scene(12, 4, Primitive::triangles,
                                   {points.point(0, 2, 16),
                                    points.point(9, 12, 16),
                                    {},
                                    points.point(0, 2, 16),
                                    points.point(9, 12, 16),
                                    {}});
  scene.target.depth = DepthFormat::depth32f;
  Draw& draw = scene.draws.front();
  const std::int64_t heights[] = {-60000, 50000, 0, 55000, -50000, 3000};
  for (std::size_t i = 0; i < draw.vertices.size(); ++i) {
    Vertex& vertex = draw.vertices[i];
    if (i % 3 == 2) vertex.position = points.point(i == 2 ? 8 : 1, i == 2 ? 12 : 4, 16);
    vertex.z = Fixed::from_raw(heights[i]);
    vertex.color = {i < 3 ? 1.0F : 0.0F, i < 3 ? 0.0F : 1.0F, 0, 1};
  }
  draw.operations.depth = {CompareFunction::less, true};
  return scene;
}

Result under(const Scene& scene, const std::string& rule, const std::string& alternative) {
  Rendering rendered = rasterize(scene, policy_with(rule, alternative));
  rendered.sample_positions = rasterize(scene, {}).sample_positions;
  return judge_output(scene, {}, rendered);
}

TEST(OutputSamples, DepthsOfOtherPlacesAreNamed) {
  for (const char* name : {"centre", "mirrored-x"}) {
    const Result result = under(crossing(), "sample.depth", name);
    EXPECT_EQ(result.verdict, Verdict::violation);
    Names reported_causes;
    for (const Disagreement& d : result.disagreements)
      if (d.rule != "fragment.depth") reported_causes.insert(text_of(d.cause));
    EXPECT_EQ(reported_causes, Names{"sample.depth=" + std::string(name)}) << described(result);
  }
}

TEST(OutputSamples, AnIgnoredSwitchIsNamed) {
  Scene scene = crossing();
  scene.draws.front().multisampling.enabled = false;
  const Result result = under(scene, "sample.enable", "ignored");
  EXPECT_EQ(result.verdict, Verdict::violation);
  EXPECT_EQ(disagreement_causes_of(result), Names{"sample.enable=ignored"}) << described(result);
}

TEST(OutputSamples, OtherMasksOfAlphaAreConventions) {
  Scene scene = crossing();
  Draw& draw = scene.draws.front();
  draw.multisampling.alpha_to_coverage = true;
  for (Vertex& vertex : draw.vertices) vertex.color[3] = 0.39F;
  const Result result = under(scene, "sample.alpha-to-coverage", "spread");
  EXPECT_EQ(result.verdict, Verdict::convention) << described(result);
  EXPECT_EQ(aggregate_causes_of(result), Names{"sample.alpha-to-coverage=spread"});
  // A fragment of alpha 1 writes all samples.
  for (Vertex& vertex : draw.vertices) vertex.color[3] = 1;
  Rendering rendered = rasterize(scene, {});
  EXPECT_EQ(judge_output(scene, {}, rendered).verdict, Verdict::agree);
  const auto hit = std::ranges::find(rendered.hits, 1u);
  ASSERT_NE(hit, rendered.hits.end());
  *hit = 0;
  const Result missing = judge_output(scene, {}, rendered);
  EXPECT_EQ(missing.verdict, Verdict::violation);
  EXPECT_EQ(missing.disagreements.size(), 1u) << described(missing);
}

TEST(OutputSamples, ResolvedPixelsOfSamplesThatAreNotReported) {
  RandomScenes random(86);
  int caught = 0;
  for (int i = 0; i < 60; ++i) {
    const Scene scene = random_multisampled_output_scene(random);
    Rendering rendered = rasterize(scene, {});
    rendered.sample_pixels.clear();
    ASSERT_EQ(judge_output(scene, {}, rendered).verdict, Verdict::agree) << i;
    std::uint8_t& code = rendered.pixels[4 * rendered.pixel_index(4, 4)];
    code = static_cast<std::uint8_t>(code + 128);
    const Result result = judge_output(scene, {}, rendered);
    if (result.verdict != Verdict::contested && result.verdict != Verdict::violation) continue;
    ++caught;
    EXPECT_TRUE(rules_of(result).contains("sample.resolve") ||
                rules_of(result).contains("sample.alpha-to-coverage"))
        << described(result);
  }
  EXPECT_GT(caught, 40);
}

}  // namespace
}  // namespace edgecase
