// SPDX-License-Identifier: MIT
//
// Under every policy a lookup has one answer, as narrow as double precision allows; and a policy
// changes no more than what it is about.
#include <gtest/gtest.h>

#include "raster/texture_stage.h"
#include "tests/raster/random_textured_scenes.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

// Each alternative by itself, and some together.
std::vector<TextureChoice> all_choices() {
  std::vector<TextureChoice> choices(1);
  const auto vary = [&](auto member, auto values) {
    for (const auto value : values) choices.emplace_back().*member = value;
  };
  vary(&TextureChoice::texel_grid,
       std::array{TexelGrid::floor_8, TexelGrid::nearest_8, TexelGrid::linear_even_8});
  vary(&TextureChoice::scale_factor, values_of<ScaleFactor>());
  vary(&TextureChoice::log2, values_of<Log2Method>());
  vary(&TextureChoice::derivatives, values_of<DerivativeMethod>());
  vary(&TextureChoice::bias, std::array{BiasChoice::half_a_level_more});
  vary(&TextureChoice::crossover, std::array{Crossover::by_filters});
  vary(&TextureChoice::nearest_level, values_of<NearestLevel>());
  vary(&TextureChoice::level_weight, values_of<LevelWeight>());
  const std::size_t alone = choices.size();
  for (std::size_t i = 1; i < alone; ++i) {
    TextureChoice both = choices[i];
    both.level_weight = LevelWeight::nearest_8;
    both.bias = BiasChoice::half_a_level_more;
    choices.push_back(both);
  }
  return choices;
}

// 1/w at the pixels around is more than 0, so that nothing is endless.
bool is_in_front(const PrimitiveAttributes& attributes, PixelPosition pixel) {
  Interpolant inverse_w = attributes.inverse_w;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      if (!(interpolate_exact(inverse_w, pixel_centre(pixel.x + x, pixel.y + y)).low > 0.01))
        return false;
  return true;
}

TEST(TexturePolicies, EveryChoiceHasOneAnswer) {
  TexturedScenes scenes(3);
  int fragments = 0;
  const std::vector<TextureChoice> all = all_choices();
  for (std::uint64_t i = 0; i < 1'500; ++i) {
    Scene scene = scenes.next();
    if (!is_in_share(i)) continue;
    if (i % 4 == 0) scene.draws[0].texture->sampler.max_anisotropy = 3.5F;
    RuleChoices choices;
    choices.textures = all[i % all.size()];
    if (i % 8 == 0) choices.textures.anisotropy = Anisotropy::gaussian_5;
    const TextureStage stage(scene, choices);
    const ScenePrimitive primitive = primitives_of(scene).at(0);
    const auto attributes = attributes_of(primitive, choices, scene.target);
    const double scale = scene.textures[0]->format == TextureFormat::rgba32f ? 100 : 1;
    for (const PixelPosition pixel : {PixelPosition{1, 1}, {4, 3}, {6, 7}, {2, 5}}) {
      if (!is_in_front(attributes, pixel)) continue;
      const ExactLookup lookup = stage.look_up(primitive, attributes, pixel);
      ASSERT_LE(width_of(lookup.accessed), 1e-9) << i;
      for (const Interval& component : lookup.color)
        ASSERT_LE(width_of(component), 1e-10 * scale) << i << ": " << pixel.x << ", " << pixel.y;
      ++fragments;
    }
  }
  EXPECT_GT(fragments, least_of(4'000));
}

bool meet(Interval a, Interval b) {
  return a.low <= b.high && b.low <= a.high;
}

// Looked up one by one or one after another: what pixels share is the same.
TEST(TexturePolicies, PixelsOfAPrimitiveAgreeWithEachByItself) {
  TexturedScenes scenes(4);
  const RuleChoices choices;
  for (int i = 0; i < 300; ++i) {
    const Scene scene = scenes.next();
    const TextureStage stage(scene, choices);
    const ScenePrimitive primitive = primitives_of(scene).at(0);
    const auto attributes = attributes_of(primitive, choices, scene.target);
    TexturedPrimitive textured(stage, primitive, attributes);
    for (const PixelPosition pixel : {PixelPosition{7, 0}, {0, 7}, {3, 3}, {3, 2}}) {
      if (!is_in_front(attributes, pixel)) continue;
      const ExactLookup shared = textured.look_up(pixel);
      const ExactLookup alone = stage.look_up(primitive, attributes, pixel);
      ASSERT_TRUE(meet(shared.lambda, alone.lambda));
      for (std::size_t c = 0; c < 4; ++c) ASSERT_TRUE(meet(shared.color[c], alone.color[c]));
    }
  }
}

}  // namespace
}  // namespace edgecase
