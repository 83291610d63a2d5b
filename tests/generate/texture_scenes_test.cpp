// SPDX-License-Identifier: MIT
#include "generate/texture_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "casefile/case_writer.h"
#include "casefile/scene/viewport.h"
#include "raster/rasterizer.h"
#include "raster/texture_stage.h"

namespace edgecase {
namespace {

constexpr std::array kQuestions{TextureQuestion::implicit_tie, TextureQuestion::bias_tie,
                                TextureQuestion::explicit_tie, TextureQuestion::crossover};

// All kinds of scenes, a few each.
std::vector<Scene> all_scenes(std::uint64_t seed, Surface surface) {
  std::vector<Scene> scenes;
  for (std::uint64_t i = 0; i < 6; ++i) {
    for (const TextureQuestion question : kQuestions)
      scenes.push_back(texture_probe({seed, surface, question}, i));
    for (const RampKind kind : values_of<RampKind>())
      scenes.push_back(ramp_scene({seed, surface, kind}, i));
  }
  return scenes;
}

TEST(TextureScenes, ReachOpenGlExactly) {
  for (const Surface surface : {Surface::fbo, Surface::window})
    for (const Scene& scene : all_scenes(1, surface)) {
      EXPECT_EQ(scene.target.surface, surface);
      EXPECT_TRUE(scene.details.texture);
      for (const Draw& draw : scene.draws)
        for (const Vertex& v : draw.vertices) {
          EXPECT_FALSE(
              find_inexactness(v.position.x, {scene.viewport.x, scene.viewport.width}, 'x', v.w));
          EXPECT_FALSE(
              find_inexactness(v.position.y, {scene.viewport.y, scene.viewport.height}, 'y', v.w));
          for (const float coordinate : v.texture_coordinates)
            EXPECT_TRUE(std::isfinite(coordinate));
        }
    }
}

TEST(TextureScenes, CanBeWrittenAsCases) {
  for (const Scene& scene : all_scenes(1, Surface::fbo))
    EXPECT_TRUE(case_text(scene, {"", "t", "w", {"texture.log2"}, "", "", {}}).diagnostics.empty());
}

// Everything that a random member draws its numbers into.
std::vector<float> numbers_of(const Scene& scene) {
  std::vector<float> numbers;
  for (const auto& texture : scene.textures)
    for (const TextureLevel& level : texture->levels)
      numbers.insert(numbers.end(), level.texels.begin(), level.texels.end());
  for (const Draw& draw : scene.draws) {
    numbers.push_back(draw.texture->sampler.lod_bias);
    numbers.push_back(draw.texture->lookup.value);
    for (const Vertex& v : draw.vertices)
      numbers.insert(numbers.end(), v.texture_coordinates.begin(), v.texture_coordinates.end());
  }
  return numbers;
}

TEST(TextureScenes, AreFunctionsOfSeedSurfaceAndIndex) {
  const auto first = all_scenes(1, Surface::fbo);
  const auto again = all_scenes(1, Surface::fbo);
  const auto other_seed = all_scenes(2, Surface::fbo);
  const auto other_surface = all_scenes(1, Surface::window);
  std::set<std::vector<float>> all;
  std::size_t other = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(numbers_of(first[i]), numbers_of(again[i]));
    if (numbers_of(first[i]) != numbers_of(other_seed[i])) ++other;
    if (numbers_of(first[i]) != numbers_of(other_surface[i])) ++other;
    all.insert(numbers_of(first[i]));
  }
  EXPECT_EQ(other, 2 * first.size());
  EXPECT_EQ(all.size(), first.size());
}

// The exact lookups of all fragments.
std::vector<ExactLookup> exact_lookups(const Scene& scene) {
  const RuleChoices choices = resolve(Policy{}, scene.target.surface);
  const TextureStage stage(scene, choices);
  const auto primitives = primitives_of(scene);
  std::vector<ExactLookup> result;
  for (const Fragment& fragment : rasterize(scene, {}).fragments) {
    const auto& primitive = primitives[static_cast<std::size_t>(fragment.primitive)];
    result.push_back(stage.look_up(primitive, attributes_of(primitive, choices, scene.target),
                                   {fragment.x, fragment.y}));
  }
  return result;
}

std::pair<double, double> ends_of_levels(const Scene& scene) {
  std::pair<double, double> ends{HUGE_VAL, -HUGE_VAL};
  for (const ExactLookup& lookup : exact_lookups(scene)) {
    ends.first = std::min(ends.first, lookup.lambda.low);
    ends.second = std::max(ends.second, lookup.lambda.high);
  }
  return ends;
}

TEST(Ramps, RiseFromMagnificationToTheLastLevel) {
  for (const RampKind kind : values_of<RampKind>())
    for (std::uint64_t i = 0; i < 6; ++i) {
      const Scene scene = ramp_scene({1, Surface::fbo, kind}, i);
      const double last = static_cast<double>(scene.textures[0]->levels.size()) - 1;
      const auto [low, high] = ends_of_levels(scene);
      if (kind == RampKind::perspective) {
        EXPECT_GT(high - low, 1) << i;
        continue;
      }
      // One dimension knows a footprint's u alone.
      if (scene.textures[0]->dimensions == 1) continue;
      EXPECT_LT(low, kind == RampKind::magnification ? -3 : 0) << name_of(kind) << i;
      EXPECT_GT(high, kind == RampKind::magnification ? last + 1 : last - 0.5) << name_of(kind);
    }
}

TEST(Ramps, CoverTheTarget) {
  for (const RampKind kind : values_of<RampKind>()) {
    const Scene scene = ramp_scene({1, Surface::window, kind}, 0);
    EXPECT_EQ(rasterize(scene, {}).fragments.size(), 1024u) << name_of(kind);
  }
}

// The longer vector's length over the other's.
double ratio_of(const ExactLookup& lookup) {
  const auto [x, y] = lengths(lookup.footprint);
  return std::max(middle(x), middle(y)) / std::min(middle(x), middle(y));
}

TEST(Ramps, AreElongatedAsTheyAreNamed) {
  std::set<int> ratios;
  for (const ExactLookup& lookup :
       exact_lookups(ramp_scene({1, Surface::fbo, RampKind::anisotropic}, 0)))
    ratios.insert(static_cast<int>(std::lround(std::log2(ratio_of(lookup)))));
  EXPECT_EQ(ratios, (std::set{1, 2, 3, 4}));
  for (const RampKind kind : {RampKind::diagonal, RampKind::rotated})
    for (const ExactLookup& lookup : exact_lookups(ramp_scene({1, Surface::fbo, kind}, 0)))
      EXPECT_NEAR(ratio_of(lookup), 1, 1e-5);
}

TEST(TextureProbes, FootprintsLieHalfwayBetweenLevels) {
  std::size_t ties = 0;
  for (const ExactLookup& lookup :
       exact_lookups(texture_probe({1, Surface::fbo, TextureQuestion::implicit_tie}, 0))) {
    const Interval lambda = lookup.lambda;
    if (lambda.low == lambda.high && std::fabs(std::fmod(lambda.low, 1)) == 0.5) ++ties;
  }
  EXPECT_EQ(ties, 512u);  // half the cells of a target of 32 by 32
}

}  // namespace
}  // namespace edgecase
