// SPDX-License-Identifier: MIT
//
// Alternatives of the rules on fragment operations, each planted: a renderer that is exact under
// one of them is convicted, or permitted, as the alternative's openness says, and its cause named.
#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "diff/compare.h"
#include "diff/judge.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "tests/diff/output/output_judging.h"
#include "tests/raster/operation_scenes.h"

namespace edgecase {
namespace {

bool is_different(const Rendering& a, const Rendering& b) {
  return a.pixels != b.pixels || a.depths != b.depths || a.stencils != b.stencils ||
         a.hits != b.hits || a.sample_pixels != b.sample_pixels ||
         a.fragments.size() != b.fragments.size();
}

// What is found over a run of random scenes that differ under an alternative.
struct Tally {
  int different = 0;
  int convicted = 0;
  std::map<std::string, int> named;  // scenes by what is found to be a cause in them
};

Tally planted(const std::string& rule, const Alternative& alternative, bool multisampled,
              int wanted) {
  RandomScenes random(85);
  std::vector<Result> results;
  for (int i = 0; i < 6000 && std::ssize(results) < wanted; ++i) {
    const Scene scene =
        multisampled ? random_multisampled_output_scene(random) : random_output_scene(random);
    const Rendering rendered = rasterize(scene, policy_with(rule, alternative.name));
    const Rendering exact = rasterize(scene, {});
    if (!is_different(rendered, exact)) continue;
    results.push_back(compare(scene, {}, exact, rendered, {8, nullptr}));
  }
  std::vector<Result*> run;
  for (Result& result : results) run.push_back(&result);
  judge(run, Latitude::opengl);
  Tally tally;
  for (const Result& result : results) {
    EXPECT_NE(result.verdict, Verdict::agree);
    ++tally.different;
    const bool is_contested = result.verdict == Verdict::contested;
    tally.convicted += is_contested || result.verdict == Verdict::violation ? 1 : 0;
    std::set<std::string> causes = disagreement_causes_of(result);
    EXPECT_FALSE(causes.contains("")) << described(result);
    causes.merge(aggregate_causes_of(result));
    for (const std::string& cause : causes) ++tally.named[cause];
  }
  return tally;
}

// At least this share of what differs is convicted, where the alternative is illegal: what remains
// is inside the latitude of depths.
void expect_named(const std::string& rule, bool multisampled, int wanted, double convicted = 0.9) {
  for (const Alternative& alternative : find_rule(rule)->alternatives) {
    if (alternative.name == find_rule(rule)->standard) continue;
    // No draw of such a scene meets a sample twice.
    if (multisampled && alternative.name == "once-a-draw") continue;
    const Tally tally = planted(rule, alternative, multisampled, wanted);
    const std::string which = rule + "=" + alternative.name;
    EXPECT_GE(tally.different, wanted / 2) << which;
    if (alternative.openness == Openness::illegal) {
      EXPECT_GE(tally.convicted, convicted * tally.different) << which;
    } else {
      EXPECT_EQ(tally.convicted, 0) << which;
    }
    // A single scene may not tell it from another one that does the same there; a run does.
    for (const auto& [cause, scenes] : tally.named)
      EXPECT_LE(scenes, tally.named.contains(which) ? tally.named.at(which) : 0)
          << cause << " for " << which;
  }
}

TEST(OutputAlternatives, OfTheDepthTest) {
  expect_named("depth.test", false, 40, 0.6);
  expect_named("depth.mask", false, 40);
}
TEST(OutputAlternatives, OfTheStencilTest) {
  expect_named("stencil.test", false, 40);
}
TEST(OutputAlternatives, OfBlending) {
  expect_named("blend.equation", false, 40);
  expect_named("color.mask", false, 40);
}

// Many colours of many alphas over one another, and over them one whose product by its alpha, 188
// times 196 in codes, depends on how products are divided, as few do.
Scene gradients() {
  Scene scene = operation_scene(32, DepthFormat::none, StencilFormat::none);
  for (int i = 0; i < 3; ++i) {
    Draw draw = rectangle({0, 0, 32, 32}, 0.5, kWhite);
    draw.interpolation = Interpolation::smooth;
    for (std::size_t v = 0; v < draw.vertices.size(); ++v)
      draw.vertices[v].color = {static_cast<float>(v % 2), static_cast<float>(v / 2) * 0.9F,
                                static_cast<float>(v) / 3, 0.3F + 0.2F * static_cast<float>(i)};
    draw.operations.blending =
        Blending{{BlendEquation::add, BlendFactor::src_alpha, BlendFactor::one_minus_src_alpha},
                 {BlendEquation::add, BlendFactor::one, BlendFactor::one_minus_src_alpha},
                 {}};
    scene.draws.push_back(std::move(draw));
  }
  Draw last = scene.draws[0];
  for (Vertex& vertex : last.vertices)
    vertex.color = {188 / 255.0F, 188 / 255.0F, 188 / 255.0F, 196 / 255.0F};
  scene.draws.push_back(std::move(last));
  return scene;
}

TEST(OutputAlternatives, RoundingsOfBlendingAreConventions) {
  const Scene scene = gradients();
  for (const Alternative& alternative : find_rule("blend.rounding")->alternatives) {
    if (alternative.name == "once") continue;
    const std::string cause = "blend.rounding=" + alternative.name;
    Rendering rendered = rasterize(scene, policy_with("blend.rounding", alternative.name));
    Result result = judge_output(scene, {}, rendered);
    EXPECT_EQ(result.verdict, Verdict::convention) << described(result);
    EXPECT_EQ(aggregate_causes_of(result), std::set<std::string>{cause});
    // One pixel that it does not make, and nothing accounts for all.
    std::uint8_t& green = rendered.pixels[4 * rendered.pixel_index(20, 20) + 1];
    green = rasterize(scene, {}).pixels[4 * rendered.pixel_index(20, 20) + 1];
    green = static_cast<std::uint8_t>(green - 1);
    result = judge_output(scene, {}, rendered);
    EXPECT_EQ(result.verdict, Verdict::permitted) << described(result);
    EXPECT_EQ(judge_output(scene, {}, rendered, Latitude::none).verdict, Verdict::violation);
  }
}

TEST(OutputAlternatives, OfFacing) {
  expect_named("polygon.facing", false, 40);
}
TEST(OutputAlternatives, OfMultisampledScenes) {
  for (const char* rule : {"stencil.test", "depth.mask", "blend.equation", "color.mask"})
    expect_named(rule, true, 10);
  // No depth of a sample is told, so that ties may go either way.
  expect_named("depth.test", true, 10, 0);
}

}  // namespace
}  // namespace edgecase
