// SPDX-License-Identifier: MIT
//
// Colours that the texture stage looks up, against texels taken by hand: rows of probes, two levels
// at once, ties of grids, and the chains of several textures.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "raster/texture_stage.h"
#include "tests/raster/random_scenes.h"
#include "tests/raster/texture_scenes.h"

namespace edgecase {
namespace {

// Each component of a texel tells something else of it; none is 0.
std::array<float, 4> texel_at(int i, int j, int level) {
  return {static_cast<float>(i + 1), static_cast<float>(j + 1),
          static_cast<float>(7 * i + 3 * j + 1), static_cast<float>(100 * level + i * j + 1)};
}

int wrapped_into(double texels, int size) {
  const auto texel = static_cast<int>(std::floor(texels));
  return (texel % size + size) % size;
}

// What is looked up over a rectangle of 16 by 16 pixels that shows the image
// once.
ExactLookup look_up(const Texture& texture, const Sampler& sampler, const Lookup& lookup,
                    const TextureChoice& choice, PixelPosition pixel) {
  Scene scene = textured_scene(16, 16, texture, {{0, 0}, {16, 16}, {}, {1, 1}}, sampler);
  scene.draws[0].texture->lookup = lookup;
  RuleChoices choices;
  choices.textures = choice;
  const TextureStage stage(scene, choices);
  const ScenePrimitive primitive = primitives_of(scene).at(0);
  return stage.look_up(primitive, attributes_of(primitive, choices, scene.target), pixel);
}

struct Row {
  std::array<double, 2> longer;   // texels
  std::array<double, 2> shorter;  // a whole fraction of it
  Anisotropy choice = Anisotropy::extension;
  std::vector<double> offsets;
  std::vector<double> weights;
};

Row equal_row(std::array<double, 2> longer, std::array<double, 2> shorter, int count) {
  Row row{longer, shorter, Anisotropy::extension, {}, {}};
  for (int i = 1; i <= count; ++i) {
    row.offsets.push_back(i / (count + 1.0) - 0.5);
    row.weights.push_back(1.0 / count);
  }
  return row;
}

Row gaussian_row(std::array<double, 2> longer, std::array<double, 2> shorter) {
  Row row{longer, shorter, Anisotropy::gaussian_5, {}, {}};
  double sum = 0;
  for (int i = -2; i <= 2; ++i) {
    row.offsets.push_back(i / 5.0);
    row.weights.push_back(std::exp(-2 * (2 * i / 5.0) * (2 * i / 5.0)));
    sum += row.weights.back();
  }
  for (double& weight : row.weights) weight /= sum;
  return row;
}

// The colour is the weighted mean of the texels that hold the probes, in every component.
void compare(const Row& row, int dimensions, bool along_x) {
  const int width = 32, height = dimensions == 1 ? 1 : 16;
  Texture texture = single_of(width, height, TextureFormat::rgba32f, texel_at);
  texture.dimensions = dimensions;
  Sampler sampler = sampler_of(Filter::nearest, MipFilter::none);
  sampler.max_anisotropy = 16;
  Lookup lookup;
  lookup.kind = LookupKind::gradients;
  const auto in_image = [&](const std::array<double, 2>& texels) {
    return std::array{static_cast<float>(texels[0] / width),
                      static_cast<float>(texels[1] / height)};
  };
  lookup.dx = in_image(along_x ? row.longer : row.shorter);
  lookup.dy = in_image(along_x ? row.shorter : row.longer);
  TextureChoice choice;
  choice.anisotropy = row.choice;
  for (const PixelPosition p : {PixelPosition{3, 5}, {8, 8}, {12, 2}}) {
    const ExactLookup found = look_up(texture, sampler, lookup, choice, p);
    const double u = (p.x + 0.5) / 16 * width, v = (p.y + 0.5) / 16 * height;
    std::array<double, 4> expected{};
    for (std::size_t i = 0; i < row.offsets.size(); ++i) {
      const int column = wrapped_into(u + row.offsets[i] * row.longer[0], width);
      const int line =
          dimensions == 1 ? 0 : wrapped_into(v + row.offsets[i] * row.longer[1], height);
      const auto texel = texel_at(column, line, 0);
      for (std::size_t c = 0; c < 4; ++c)
        expected[c] += row.weights[i] * static_cast<double>(texel[c]);
    }
    for (std::size_t c = 0; c < 4; ++c) {
      EXPECT_NEAR(found.color[c].low, expected[c], 1e-11) << c;
      EXPECT_NEAR(found.color[c].high, expected[c], 1e-11) << c;
    }
  }
}

TEST(TextureColors, ProbesAreWeightedTexels) {
  for (const bool along_x : {false, true}) {
    compare(equal_row({4, 8}, {-4, 2}, 2), 2, along_x);
    compare(equal_row({4, -12}, {3, 1}, 4), 2, along_x);
    compare(gaussian_row({7, 11}, {1, 0}), 2, along_x);
    compare(equal_row({9, 5}, {-3, 7}, 3), 1, along_x);
    compare(gaussian_row({11, 5}, {1, 7}), 1, along_x);
  }
}

// A third of the image is within a texel of the one level, of 7, and on a border of the other,
// of 3.
TEST(TextureColors, BordersOfBothLevelsCount) {
  Texture texture = chain_of(7, 1, TextureFormat::rgba32f, texel_at);
  texture.dimensions = 1;
  Lookup lookup;
  lookup.kind = LookupKind::lod;
  lookup.value = 0.25F;
  Scene scene = textured_scene(3, 1, texture, {{0.5, 0}, {3, 1}, {}, {1, 1}},
                               sampler_of(Filter::nearest, MipFilter::linear));
  scene.draws[0].texture->lookup = lookup;
  const RuleChoices choices;
  const TextureStage stage(scene, choices);
  const ScenePrimitive primitive = primitives_of(scene).at(0);
  const auto attributes = attributes_of(primitive, choices, scene.target);
  for (int k = 0; k < 3; ++k) {
    const ExactLookup found = stage.look_up(primitive, attributes, {k, 0});
    const auto first = texel_at(7 * k / 3, 0, 0), second = texel_at(k, 0, 1);
    for (std::size_t c = 0; c < 4; ++c) {
      const double expected =
          0.75 * static_cast<double>(first[c]) + 0.25 * static_cast<double>(second[c]);
      EXPECT_NEAR(found.color[c].low, expected, 1e-12) << k;
      EXPECT_NEAR(found.color[c].high, expected, 1e-12) << k;
    }
  }
}

// Far from 0 each axis is brought near as its own wrap mode allows.
TEST(TextureColors, DistantCoordinatesWrapByTheirAxis) {
  const Texture texture = single_of(3, 3, TextureFormat::rgba32f, texel_at);
  constexpr float kFar = 0x1p20F;
  for (const bool s_repeats : {false, true}) {
    Sampler sampler = sampler_of(Filter::nearest, MipFilter::none, Wrap::clamp_to_edge);
    sampler.wrap[s_repeats ? 0 : 1] = Wrap::repeat;
    // Pixel k lies k/3 further than 2^20.
    const Scene scene = textured_scene(
        4, 4, texture, {{0.5, 0.5}, {3, 3}, {kFar, kFar}, {kFar + 1, kFar + 1}}, sampler);
    const RuleChoices choices;
    const TextureStage stage(scene, choices);
    const ScenePrimitive primitive = primitives_of(scene).at(0);
    const auto attributes = attributes_of(primitive, choices, scene.target);
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x) {
        const auto expected = texel_at(s_repeats ? x : 2, s_repeats ? 2 : y, 0);
        const ExactLookup found = stage.look_up(primitive, attributes, {x, y});
        for (std::size_t c = 0; c < 4; ++c) {
          EXPECT_EQ(found.color[c].low, expected[c]) << x << ", " << y;
          EXPECT_EQ(found.color[c].high, expected[c]) << x << ", " << y;
        }
      }
  }
}

// Of 12, 6, 3 and 1 texels the third level is looked up, at ties of its grid: they go to the even
// step, though on the grids of the larger levels there is no tie.
TEST(TextureColors, TiesAreThoseOfTheLevelThatIsLookedUp) {
  const int shades[] = {10, 200, 90};
  Texture texture = chain_of(12, 1, TextureFormat::rgba8, [&](int i, int, int level) {
    const auto shade = static_cast<float>(level == 2 ? shades[i] : 0);
    return std::array<float, 4>{shade, 0, 0, 255};
  });
  texture.dimensions = 1;
  Scene scene = textured_scene(16, 1, texture, {{0.5, 0}, {3 * 512, 1}, {}, {1, 1}},
                               sampler_of(Filter::linear, MipFilter::nearest));
  scene.draws[0].texture->lookup.kind = LookupKind::lod;
  scene.draws[0].texture->lookup.value = 2;
  RuleChoices choices;
  choices.textures.texel_grid = TexelGrid::linear_even_8;
  const TextureStage stage(scene, choices);
  const ScenePrimitive primitive = primitives_of(scene).at(0);
  const auto attributes = attributes_of(primitive, choices, scene.target);
  for (int halves = 257; halves < 700; halves += 2) {  // of a step of 1/256 texel
    const ExactLookup found = stage.look_up(primitive, attributes, {halves, 0});
    const int step = halves % 4 == 1 ? (halves - 1) / 2 : (halves + 1) / 2;
    const int from_centre = step - 128;
    const int below = from_centre / 256;
    const double weight = from_centre % 256 / 256.0;
    const double expected = ((1 - weight) * shades[below] + weight * shades[(below + 1) % 3]) / 255;
    ASSERT_NEAR(found.color[0].low, expected, 1e-12) << halves;
    ASSERT_NEAR(found.color[0].high, expected, 1e-12) << halves;
  }
}

Texture generated_of(int width, int height, float shade) {
  Texture texture = single_of(width, height, TextureFormat::rgba8, [&](int, int, int) {
    return std::array<float, 4>{shade, 0, 0, 255};
  });
  texture.generated = true;
  return texture;
}

// Every texture of a scene is decoded, and chains are taken only where they fit.
TEST(TextureColors, ChainsOfSeveralTextures) {
  Scene scene = textured_scene(4, 4, generated_of(4, 2, 51), {{0, 0}, {4, 4}, {}, {1, 1}},
                               sampler_of(Filter::nearest, MipFilter::nearest));
  scene.textures.push_back(
      std::make_shared<const Texture>(single_of(2, 2, TextureFormat::rgba8, distinct)));
  scene.textures.push_back(std::make_shared<const Texture>(generated_of(4, 2, 102)));
  const RuleChoices choices;
  TextureStage stage(scene, choices);
  ASSERT_EQ(stage.chains().size(), 2U);
  EXPECT_EQ(stage.decoded(0).levels.size(), 3U);
  EXPECT_EQ(stage.decoded(1).levels.size(), 1U);
  EXPECT_TRUE(stage.decoded(2).levels[1].at(0, 0)[0].contains(0.4));

  const auto white = [](int width, int height) {
    TextureLevel level{width, height, {}};
    level.texels.assign(static_cast<std::size_t>(4 * width * height), 255);
    return level;
  };
  // As wide, but not as high; as high, but not as wide; of a texture that has no chain.
  stage.take_chains({{0, {white(4, 2), white(2, 2), white(1, 1)}},
                     {1, {white(2, 2), white(1, 1)}},
                     {2, {white(4, 2), white(1, 1), white(1, 1)}},
                     {7, {white(4, 2), white(2, 1), white(1, 1)}}});
  EXPECT_EQ(stage.chains().size(), 2U);
  EXPECT_EQ(stage.decoded(1).levels.size(), 1U);
  EXPECT_TRUE(stage.decoded(0).levels[1].at(0, 0)[0].contains(0.2));
  EXPECT_TRUE(stage.decoded(2).levels[1].at(0, 0)[0].contains(0.4));
  stage.take_chains({{2, {white(4, 2), white(2, 1), white(1, 1)}}});
  EXPECT_EQ(stage.decoded(2).levels[1].at(0, 0)[0].low, 1);
  EXPECT_TRUE(stage.decoded(0).levels[1].at(0, 0)[0].contains(0.2));
}

}  // namespace
}  // namespace edgecase
