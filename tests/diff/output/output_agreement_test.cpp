// SPDX-License-Identifier: MIT
//
// Scenes with fragment operations: exact agrees with itself, under every policy; what a policy has
// that OpenGL does not is held against OpenGL all the same.
#include <gtest/gtest.h>

#include "diff/coverage/cause.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "tests/diff/output/output_judging.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

constexpr const char* kRules[] = {
    "depth.test", "depth.mask",     "stencil.test", "blend.equation", "blend.rounding",
    "color.mask", "polygon.facing", "offset.slope", "offset.unit",    "offset.exponent"};

TEST(OutputAgreement, OfRandomScenes) {
  RandomScenes random(81);
  std::size_t fragments = 0;
  for (int i = 0; i < 1500; ++i) {
    const Scene scene = random_output_scene(random);
    const Rendering exact = rasterize(scene, {});
    fragments += exact.fragments.size();
    const Result result = judge_output(scene, {}, exact);
    ASSERT_EQ(result.verdict, Verdict::agree) << i << ": " << described(result);
  }
  EXPECT_GT(fragments, 20000u);
}

TEST(OutputAgreement, OfMultisampledScenes) {
  RandomScenes random(82);
  for (int i = 0; i < 300; ++i) {
    const Scene scene = random_multisampled_output_scene(random);
    const Result result = judge_output(scene, {}, rasterize(scene, {}));
    ASSERT_EQ(result.verdict, Verdict::agree) << i << ": " << described(result);
  }
}

// Renderers tell float32 numbers, keep values to themselves, or lack planes.
TEST(OutputAgreement, OfFloatsAndOfPlanesThatAreNotReported) {
  RandomScenes random(83);
  for (int i = 0; i < 400; ++i) {
    const Scene scene = random_output_scene(random);
    Rendering silent = rasterize(scene, {});
    for (Fragment& f : silent.fragments) f.has_color = f.has_depth = false;
    if (i % 3 == 0) silent.hits.clear();
    if (i % 3 == 1) silent.stencils.clear();
    if (i % 5 == 0) silent.depths.clear();
    const Result result = judge_output(scene, {}, silent);
    ASSERT_EQ(result.verdict, Verdict::agree) << i << ": " << described(result);
  }
}

TEST(OutputAgreement, UnderEveryPolicy) {
  RandomScenes random(84);
  Dealer dealer;
  for (const char* rule : kRules)
    for (const Alternative& alternative : find_rule(rule)->alternatives)
      for (int i = 0; i < 60; ++i) {
        const Scene scene =
            i % 4 == 0 ? random_multisampled_output_scene(random) : random_output_scene(random);
        if (!dealer.deal()) continue;
        const Policy policy = policy_with(rule, alternative.name);
        const Rendering exact = rasterize(scene, policy);
        Result result = judge_output(scene, policy, exact, Latitude::none);
        ASSERT_EQ(result.verdict, Verdict::agree)
            << rule << "=" << alternative.name << " " << i << ": " << described(result);
        result = judge_output(scene, policy, exact);
        if (alternative.openness == Openness::illegal) {
          for (const Disagreement& d : result.disagreements)
            ASSERT_TRUE(d.policy_agrees) << described(result);
          ASSERT_TRUE(result.values.empty())
              << rule << "=" << alternative.name << described(result);
        } else {
          ASSERT_EQ(result.verdict, Verdict::agree)
              << rule << "=" << alternative.name << " " << i << ": " << described(result);
        }
      }
}

// A renderer that stores fewer bits, as the policy has it, breaks OpenGL all the same.
TEST(OutputAgreement, FewerDepthBitsOfAPolicyAreHeldAgainstOpenGL) {
  const Fixed half = Fixed::from_raw(Fixed::kOne / 2);
  Draw draw = make_draw(Primitive::points, std::vector{Point{half, half}});
  draw.operations.depth = {CompareFunction::less, true};
  draw.vertices[0].z = Fixed::from_raw(-12345);
  Scene scene = blank_scene(1, 1);
  scene.target.depth = DepthFormat::depth24;
  scene.draws = {draw};
  const Policy policy = policy_with("framebuffer.depth-bits", "sixteen");
  const Rendering exact = rasterize(scene, policy);
  ASSERT_NE(exact.depths, rasterize(scene, {}).depths);
  EXPECT_EQ(judge_output(scene, policy, exact, Latitude::none).verdict, Verdict::agree);
  const Result result = judge_output(scene, policy, exact);
  EXPECT_EQ(result.verdict, Verdict::violation) << described(result);
  ASSERT_FALSE(result.disagreements.empty());
  EXPECT_TRUE(result.disagreements[0].policy_agrees);
}

}  // namespace
}  // namespace edgecase
