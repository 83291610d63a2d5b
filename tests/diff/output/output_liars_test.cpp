// SPDX-License-Identifier: MIT
//
// Renderers that tell right fragments and show what these do not make.
#include <gtest/gtest.h>

#include <algorithm>

#include "raster/rasterizer.h"
#include "rules/values/framebuffer.h"
#include "tests/diff/output/output_judging.h"
#include "tests/raster/operation_scenes.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

using Names = std::set<std::string>;

// Three rectangles one behind another, the middle one blended, all counted in the stencil buffer.
Scene layered(int samples = 1) {
  Scene scene = operation_scene(6);
  scene.target.samples = samples;
  scene.draws = {rectangle({1, 1, 4, 4}, 0.5, {1, 0, 0, 1}),
                 rectangle({0, 0, 4, 4}, 0.3, {0, 0.6F, 0, 0.37F}),
                 rectangle({2, 0, 3, 6}, 0.4, {0, 0, 1, 1})};
  StencilFace face;
  face.pass = StencilOperation::incr;
  for (Draw& draw : scene.draws) {
    draw.operations.depth = {CompareFunction::less, true};
    draw.operations.stencil = {face, face};
    draw.multisampling.enabled = samples > 1;
  }
  scene.draws[1].operations.blending =
      Blending{{BlendEquation::add, BlendFactor::src_alpha, BlendFactor::one_minus_src_alpha},
               {BlendEquation::add, BlendFactor::one, BlendFactor::one_minus_src_alpha},
               {}};
  return scene;
}

// The one disagreement there is.
void expect_one(const Result& result, const char* rule, PixelPosition at, int sample = 0) {
  EXPECT_EQ(result.verdict, Verdict::violation);
  ASSERT_EQ(result.disagreements.size(), 1u) << described(result);
  const Disagreement& d = result.disagreements.front();
  EXPECT_EQ(d.rule, rule) << described(result);
  EXPECT_EQ((PixelPosition{d.x, d.y}), at);
  EXPECT_EQ(d.sample, sample);
  EXPECT_NE(d.explanation.find("In drawing order: primitive "), std::string::npos) << d.explanation;
}

TEST(OutputLiars, TheTruthAgrees) {
  for (const int samples : {1, 4}) {
    const Scene scene = layered(samples);
    const Result result = judge_output(scene, {}, rasterize(scene, {}));
    EXPECT_EQ(result.verdict, Verdict::agree) << described(result);
  }
}

TEST(OutputLiars, AStencilValueThatIsOneOff) {
  const Scene scene = layered();
  for (const int by : {1, -1}) {
    Rendering rendered = rasterize(scene, {});
    rendered.stencils[rendered.pixel_index(3, 3)] =
        static_cast<std::uint8_t>(rendered.stencils[rendered.pixel_index(3, 3)] + by);
    expect_one(judge_output(scene, {}, rendered), "stencil.test", {3, 3});
  }
}

TEST(OutputLiars, AMissingHit) {
  const Scene scene = layered();
  Rendering rendered = rasterize(scene, {});
  --rendered.hits[rendered.pixel_index(2, 2)];
  expect_one(judge_output(scene, {}, rendered), "depth.test", {2, 2});
}

TEST(OutputLiars, AMissingHitWithoutTests) {
  Scene scene = layered();
  scene.target.stencil = StencilFormat::none;
  for (Draw& draw : scene.draws) {
    draw.operations.stencil.reset();
    draw.operations.depth = {};
  }
  Rendering rendered = rasterize(scene, {});
  --rendered.hits[rendered.pixel_index(2, 2)];
  expect_one(judge_output(scene, {}, rendered), "fragment.once", {2, 2});
}

TEST(OutputLiars, AColourThatIsOffByMoreThanIsPermitted) {
  const Scene scene = layered();
  for (const int by : {-30, 30}) {
    Rendering rendered = rasterize(scene, {});
    std::uint8_t& red = rendered.pixels[4 * rendered.pixel_index(1, 2)];
    red = static_cast<std::uint8_t>(red + by);
    expect_one(judge_output(scene, {}, rendered), "blend.equation", {1, 2});
  }
  // Where nothing is blended.
  Rendering rendered = rasterize(scene, {});
  rendered.pixels[4 * rendered.pixel_index(4, 4) + 1] += 2;
  expect_one(judge_output(scene, {}, rendered), "framebuffer.unorm8", {4, 4});
}

TEST(OutputLiars, AColourThatIsOffByOneIsPermittedWhereItIsBlended) {
  const Scene scene = layered();
  Rendering rendered = rasterize(scene, {});
  std::uint8_t& red = rendered.pixels[4 * rendered.pixel_index(1, 2)];
  red = static_cast<std::uint8_t>(red - 1);
  const Result result = judge_output(scene, {}, rendered);
  EXPECT_EQ(result.verdict, Verdict::permitted) << described(result);
  EXPECT_EQ(judge_output(scene, {}, rendered, Latitude::none).verdict, Verdict::violation);
}

// Red and alpha are written where green and alpha should be.
TEST(OutputLiars, AMaskInAnotherOrder) {
  Scene scene = layered();
  scene.draws[2].operations.color_mask = {false, true, false, true};
  Scene other = scene;
  other.draws[2].operations.color_mask = {true, false, false, true};
  other.draws[2].operations.depth = scene.draws[2].operations.depth;
  for (const bool blended : {false, true}) {
    Rendering rendered = rasterize(scene, {});
    rendered.pixels = rasterize(other, {}).pixels;
    const Result result = judge_output(scene, {}, rendered);
    EXPECT_EQ(result.verdict, Verdict::violation);
    EXPECT_EQ(rules_of(result), Names{"color.mask"}) << blended << described(result);
    for (Scene* each : {&scene, &other}) {
      each->draws[2].operations.blending = scene.draws[1].operations.blending;
      for (Vertex& vertex : each->draws[2].vertices) vertex.color = {0.75F, 0.5F, 1, 0.5F};
    }
  }
}

TEST(OutputLiars, ADepthThatNoFragmentHas) {
  Scene scene = layered();
  Rendering rendered = rasterize(scene, {});
  double& depth = rendered.depths[rendered.pixel_index(2, 2)];
  depth = to_depth(depth - 1e-5, DepthFormat::depth24);
  expect_one(judge_output(scene, {}, rendered), "framebuffer.depth", {2, 2});
  // A number that the format does not have.
  rendered = rasterize(scene, {});
  rendered.depths[rendered.pixel_index(2, 2)] += 1e-9;
  expect_one(judge_output(scene, {}, rendered), "framebuffer.depth", {2, 2});
}

TEST(OutputLiars, AWrongDepthOfOneSample) {
  const Scene scene = layered(4);
  Rendering rendered = rasterize(scene, {});
  rendered.depths[rendered.sample_index(2, 2, 3)] = to_depth(0.31, DepthFormat::depth24);
  expect_one(judge_output(scene, {}, rendered), "framebuffer.depth", {2, 2}, 3);
}

// A depth test that went wrong shows in all planes at once.
TEST(OutputLiars, AFragmentThatPassesWhereItMustFail) {
  const Scene scene = layered();
  Rendering rendered = rasterize(scene, {});
  const Rendering wrong = rasterize(scene, policy_with("depth.test", "ignored"));
  const std::size_t pixel = rendered.pixel_index(2, 2);
  std::copy_n(wrong.pixels.begin() + static_cast<std::ptrdiff_t>(4 * pixel), 4,
              rendered.pixels.begin() + static_cast<std::ptrdiff_t>(4 * pixel));
  rendered.depths[pixel] = wrong.depths[pixel];
  rendered.stencils[pixel] = wrong.stencils[pixel];
  rendered.hits[pixel] = wrong.hits[pixel];
  Result result = judge_output(scene, {}, rendered);
  expect_one(result, "depth.test", {2, 2});
  EXPECT_EQ(disagreement_causes_of(result), Names{"depth.test=ignored"});
  // Its colour alone: no state has both.
  rendered.depths[pixel] = rasterize(scene, {}).depths[pixel];
  result = judge_output(scene, {}, rendered);
  expect_one(result, "depth.test", {2, 2});
  EXPECT_EQ(disagreement_causes_of(result), Names{""});
}

// The blended one last where it came second.
TEST(OutputLiars, FragmentsInAnotherOrder) {
  Scene scene = layered();
  for (Draw& draw : scene.draws) draw.operations.depth = {};
  Scene swapped = scene;
  std::swap(swapped.draws[1], swapped.draws[2]);
  const Rendering exact = rasterize(scene, {});
  Rendering rendered = exact;
  rendered.pixels = rasterize(swapped, {}).pixels;
  ASSERT_NE(rendered.pixels, exact.pixels);
  rendered.depths = rasterize(swapped, {}).depths;
  const Result result = judge_output(scene, {}, rendered);
  EXPECT_EQ(result.verdict, Verdict::violation);
  EXPECT_EQ(rules_of(result), Names{"framebuffer.order"}) << described(result);
}

}  // namespace
}  // namespace edgecase
