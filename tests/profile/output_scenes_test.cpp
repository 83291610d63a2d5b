// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "generate/random_scenes.h"
#include "generate/random_shapes.h"
#include "profile/output/output.h"
#include "raster/rasterizer.h"
#include "rules/values/framebuffer.h"
#include "tests/generate/scene_checks.h"

namespace edgecase {
namespace {

std::vector<Scene> all_cell_scenes() {
  std::vector<Scene> all = plain_color_scenes(Surface::fbo);
  const auto add = [&](std::vector<Scene> scenes) {
    for (Scene& scene : scenes) all.push_back(std::move(scene));
  };
  add(color_mask_scenes(1, Surface::fbo));
  add(blend_scenes(1, Surface::fbo));
  for (const DepthFormat format : kDepthFormats) {
    add(depth_code_scenes(1, Surface::fbo, format));
    add(depth_test_scenes(1, Surface::fbo, format));
    add(stencil_scenes(1, Surface::fbo, format));
    add(offset_unit_scenes(Surface::fbo, format));
    add(offset_slope_scenes(1, Surface::fbo, format));
  }
  return all;
}

// However vertices are snapped and ties decided.
TEST(OutputScenes, TrianglesCoverThePixelOfTheirCellAlone) {
  for (const Scene& scene : all_cell_scenes()) {
    ASSERT_EQ(fault_of(scene), "");
    for (const ScenePrimitive& primitive : primitives_of(scene)) {
      const Point corner = primitive.vertices[0]->position;
      const std::vector<PixelPosition> cell{
          {static_cast<int>(corner.x.floor()), static_cast<int>(corner.y.floor())}};
      for (const char* ties : {"open", "closed"}) {
        CoverageChoice choice;
        choice.ties = *find_tie_rule(ties);
        choice.snap = *find_snap("4-half-even");
        ASSERT_EQ(covered_pixels(primitive, scene.target, choice), cell);
      }
    }
  }
}

TEST(OutputScenes, OffsetsStayWithinTheRangeOfDepths) {
  for (const DepthFormat format : kDepthFormats)
    for (const char* unit : {"step", "four-steps"}) {
      Policy policy;
      policy.rules = {{"offset.unit", unit}};
      auto scenes = offset_unit_scenes(Surface::fbo, format);
      for (Scene& scene : offset_slope_scenes(1, Surface::fbo, format))
        scenes.push_back(std::move(scene));
      for (const Scene& scene : scenes)
        for (const Fragment& fragment : rasterize(scene, policy).fragments) {
          ASSERT_GT(fragment.depth, 0);
          ASSERT_LT(fragment.depth, 1);
        }
    }
}

// Converting to the nearest code and truncating have the same of what is stored and tested.
TEST(OutputScenes, TestedDepthsAreFarFromTheMiddleBetweenCodes) {
  for (const DepthFormat format : {DepthFormat::depth16, DepthFormat::depth24})
    for (const Scene& scene : depth_test_scenes(1, Surface::fbo, format))
      for (const Vertex& vertex : scene.draws[0].vertices) {
        const double depth = (vertex.z.to_double() + 1) / 2;
        const long nearest = code_by(CodeRounding::nearest, depth, bits_of(format));
        ASSERT_EQ(nearest, code_by(CodeRounding::truncated, depth, bits_of(format)));
        ASSERT_NE(nearest, code_by(CodeRounding::up, depth, bits_of(format)));
      }
}

TEST(OutputScenes, AreTheSameEveryTimeAndOthersOfAnotherSeed) {
  const auto prints_of = [](std::uint64_t seed) {
    std::set<std::uint64_t> prints;
    for (const Scene& scene : blend_scenes(seed, Surface::fbo))
      prints.insert(fingerprint_of(scene));
    return prints;
  };
  EXPECT_EQ(prints_of(1), prints_of(1));
  EXPECT_EQ(prints_of(1).size(), blend_scenes(1, Surface::fbo).size());
  EXPECT_NE(prints_of(1), prints_of(2));
}

TEST(CodeRounding, EachIsFoundByItsOwnCodes) {
  const std::vector<std::pair<CodeRounding, std::string>> all{
      {CodeRounding::nearest, "nearest"},
      {CodeRounding::nearest_of_float, "nearest-of-float32"},
      {CodeRounding::half_up_of_float, "half-up-of-float32"},
      {CodeRounding::truncated, "truncate"},
      {CodeRounding::truncated_of_float, "truncate-of-float32"},
      {CodeRounding::up, "up"},
      {CodeRounding::power_nearest, "nearest-of-power"},
      {CodeRounding::power_truncated, "truncate-of-power"}};
  std::vector<float> colors;
  for (const Scene& scene : plain_color_scenes(Surface::fbo))
    for (const Vertex& vertex : scene.draws[0].vertices)
      for (const float component : vertex.color) colors.push_back(component);
  std::vector<float> depths;
  for (const Scene& scene : depth_code_scenes(1, Surface::fbo, DepthFormat::depth16))
    for (const Fragment& fragment : rasterize(scene, {}).fragments)
      depths.push_back(static_cast<float>(fragment.depth));
  for (const auto& [rounding, name] : all)
    for (const auto& [values, bits] :
         {std::pair{&colors, 8}, std::pair{&depths, 16}, std::pair{&depths, 24}}) {
      CodeTally tally("codes", bits);
      for (const float value : *values)
        tally.add(static_cast<double>(value), code_by(rounding, static_cast<double>(value), bits));
      const Trait trait = tally.trait(TraitId("codes"));
      EXPECT_EQ(trait.rate.agreeing, trait.rate.of) << name << " " << bits;
      // Some products are as good before they are rounded to float32.
      EXPECT_TRUE(trait.alternative == name || (trait.is_undecided() && trait.runner_up == name))
          << name << " of " << bits << " bits is found to be " << trait.alternative;
    }
}

TEST(CodeRounding, EndsAreCodes) {
  for (const CodeRounding rounding : {CodeRounding::nearest, CodeRounding::power_nearest,
                                      CodeRounding::power_truncated, CodeRounding::up})
    for (const int bits : {8, 16, 24}) {
      EXPECT_EQ(code_by(rounding, -1, bits), 0);
      EXPECT_EQ(code_by(rounding, 0, bits), 0);
      EXPECT_EQ(code_by(rounding, 1, bits), (1 << bits) - 1);
      EXPECT_EQ(code_by(rounding, 2, bits), (1 << bits) - 1);
    }
  EXPECT_EQ(code_by(CodeRounding::nearest, 0.5, 8), 128);
  EXPECT_EQ(code_by(CodeRounding::truncated, 0.5, 8), 127);
  EXPECT_EQ(code_by(CodeRounding::power_truncated, 0.5, 8), 128);
}

class OutputKinds : public ::testing::TestWithParam<OutputKind> {};

TEST_P(OutputKinds, AreScenesThatOpenGlGetsExactly) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    const Scene scene = random_output_scene({3, GetParam(), Surface::fbo}, i);
    EXPECT_EQ(fault_of(scene), "");
    EXPECT_EQ(fingerprint_of(scene),
              fingerprint_of(random_output_scene({3, GetParam(), Surface::fbo}, i)));
    EXPECT_GE(scene.draws.size(), 2u);
  }
}

// What the kind is about decides what is seen in most scenes.
TEST_P(OutputKinds, DependOnTheirRules) {
  const OutputKind kind = GetParam();
  Policy other;
  other.rules = kind == OutputKind::depth_tested ? Choices{{"depth.test", "ignored"}}
                : kind == OutputKind::blended    ? Choices{{"blend.equation", "ignored"}}
                : kind == OutputKind::offset
                    ? Choices{{"offset.unit", "ignored"}, {"offset.slope", "ignored"}}
                    : Choices{{"stencil.test", "ignored"}};
  std::size_t differing = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Scene scene = random_output_scene({1, kind, Surface::fbo}, i);
    const Rendering plain = rasterize(scene, {});
    const Rendering changed = rasterize(scene, other);
    if (plain.pixels != changed.pixels || plain.stencils != changed.stencils) ++differing;
  }
  EXPECT_GT(differing, 80u);
}

INSTANTIATE_TEST_SUITE_P(OutputScenes, OutputKinds,
                         ::testing::Values(OutputKind::depth_tested, OutputKind::blended,
                                           OutputKind::offset, OutputKind::stencilled),
                         [](const auto& one) {
                           std::string name = name_of(one.param);
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

}  // namespace
}  // namespace edgecase
