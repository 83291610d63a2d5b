// SPDX-License-Identifier: MIT
//
// Fates of samples: rules on multisampled targets that show in what a depth test makes of their
// fragments, and samples that a renderer does not tell.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <span>
#include <vector>

#include "diff/output/operations_replay.h"
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

// Depths of what arrives, and whether it is kept.
std::vector<double> told(std::span<const Arrival> arrivals, Tracked tracked) {
  std::vector<double> numbers;
  for (const Arrival& arrival : arrivals) {
    numbers.insert(numbers.end(), {static_cast<double>(arrival.fragment->primitive),
                                   arrival.values.depth.exact, arrival.is_kept ? 1.0 : 0.0});
    if (tracked == Tracked::permitted)
      numbers.insert(numbers.end(),
                     {arrival.values.depth.permitted.low, arrival.values.depth.permitted.high});
  }
  return numbers;
}

// The latest answer is kept. Whatever was asked before, it answers what was asked: by the number of
// fragments from the same one on, the sample, the choice and what is tracked.
TEST(OutputSamples, ArrivalsDoNotDependOnWhatWasAskedBefore) {
  Scene scene = crossing();
  Draw& draw = scene.draws.front();
  const auto at = [](int x, int y) {
    return Point{Fixed::from_integer(x), Fixed::from_integer(y)};
  };
  const Point all[] = {at(0, 0), at(12, 0), at(0, 12)};
  for (std::size_t i = 0; i < draw.vertices.size(); ++i) draw.vertices[i].position = all[i % 3];
  const auto primitives = primitives_of(scene);
  const RuleChoices lawful = resolve({}, scene.target.surface);
  const RuleChoices other = resolve(policy_with("sample.depth", "centre"), scene.target.surface);
  const ValueContext context(scene, primitives, lawful, 8, Latitude::opengl);
  const Rendering exact = rasterize(scene, {});
  const auto pair =
      std::ranges::adjacent_find(exact.fragments, [](const Fragment& a, const Fragment& b) {
        return a.x == b.x && a.y == b.y && (a.coverage & b.coverage & 3) == 3;
      });
  ASSERT_NE(pair, exact.fragments.end());
  struct Asked {
    std::size_t fragments;
    int sample;
    const RuleChoices* choice;
    Tracked tracked;
  };
  std::vector<Asked> questions;
  for (const std::size_t fragments : {0U, 1U, 2U})
    for (const int sample : {0, 1})
      for (const RuleChoices* choice : {&lawful, &other})
        for (const Tracked tracked : {Tracked::exact, Tracked::permitted})
          questions.push_back({fragments, sample, choice, tracked});
  const auto answer = [&](const Arrivals& arrivals, const Asked& asked) {
    const std::span<const Fragment> at_pixel(&*pair, asked.fragments);
    return told(arrivals.at(at_pixel, asked.sample, *asked.choice, asked.tracked), asked.tracked);
  };
  std::set<std::vector<double>> answers;
  for (const Asked& before : questions)
    for (const Asked& asked : questions) {
      const Arrivals arrivals(context);
      answer(arrivals, before);
      const auto found = answer(arrivals, asked);
      EXPECT_EQ(found, answer(Arrivals(context), asked));
      answers.insert(found);
    }
  // None; and of one and of two fragments those of each sample and of the centre, with and without
  // what is permitted: the questions do ask for different things.
  EXPECT_EQ(answers.size(), 13U);
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
