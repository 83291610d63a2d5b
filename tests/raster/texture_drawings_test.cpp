// SPDX-License-Identifier: MIT
//
// Textured pictures that are known without computing: texel by texel, and level by level.
#include <gtest/gtest.h>

#include "raster/rasterizer.h"
#include "raster/texture_stage.h"
#include "tests/raster/random_scenes.h"
#include "tests/raster/texture_scenes.h"

namespace edgecase {
namespace {

constexpr Filter kFilters[] = {Filter::nearest, Filter::linear};

// The colour that is shown there by the single fragment of the pixel.
std::array<int, 4> pixel_of(const Rendering& rendering, int x, int y) {
  std::array<int, 4> color{};
  for (std::size_t c = 0; c < 4; ++c)
    color[c] = rendering.pixels[4 * rendering.pixel_index(x, y) + c];
  return color;
}

std::array<int, 4> texel_of(const Texture& texture, int level, int i, int j) {
  const TextureLevel& image = texture.levels[static_cast<std::size_t>(level)];
  std::array<int, 4> color{};
  for (std::size_t c = 0; c < 4; ++c)
    color[c] = static_cast<int>(image.texels[image.index(i, j) + c]);
  return color;
}

// A texel per pixel.
TEST(TextureDrawings, OneToOneIsTheTexture) {
  for (const auto& [width, height] : {std::pair{4, 4}, std::pair{5, 3}, std::pair{7, 8}}) {
    const Texture texture = single_of(width, height, TextureFormat::rgba8, distinct);
    const Placement whole{
        {0, 0}, {static_cast<double>(width), static_cast<double>(height)}, {}, {1, 1}};
    for (const Filter filter : kFilters) {
      const Rendering rendering = rasterize(
          textured_scene(width, height, texture, whole, sampler_of(filter, MipFilter::none)), {});
      ASSERT_EQ(rendering.fragments.size(), texture.levels[0].texels.size() / 4);
      for (const Fragment& f : rendering.fragments) {
        EXPECT_EQ(pixel_of(rendering, f.x, f.y), texel_of(texture, 0, f.x, f.y));
        const auto& detail = rendering.details[static_cast<std::size_t>(f.detail)];
        EXPECT_EQ(detail.level_of_detail, (std::array<double, 2>{0, 0}));
        EXPECT_DOUBLE_EQ(detail.texture_coordinates.value()[0], (f.x + 0.5) / width);
        EXPECT_DOUBLE_EQ(detail.texture_coordinates.value()[1], (f.y + 0.5) / height);
      }
    }
  }
}

// Two texels per pixel and axis: level 1, texel by texel, whichever filter is between levels.
TEST(TextureDrawings, TwoToOneIsLevelOne) {
  const Texture texture = chain_of(16, 16, TextureFormat::rgba8, distinct);
  for (const Filter filter : kFilters)
    for (const MipFilter mipmap : {MipFilter::nearest, MipFilter::linear}) {
      const Rendering rendering = rasterize(
          textured_scene(8, 8, texture, {{0, 0}, {8, 8}, {}, {1, 1}}, sampler_of(filter, mipmap)),
          {});
      ASSERT_EQ(rendering.fragments.size(), 64U);
      for (const Fragment& f : rendering.fragments) {
        EXPECT_EQ(pixel_of(rendering, f.x, f.y), texel_of(texture, 1, f.x, f.y));
        EXPECT_EQ(rendering.details[static_cast<std::size_t>(f.detail)].level_of_detail,
                  (std::array<double, 2>{1, 1}));
      }
    }
}

// Pixels' centres on the borders of texels: each belongs to the texel to the right and above.
TEST(TextureDrawings, BordersBelongToTheTexelAbove) {
  for (const int size : {4, 3, 7}) {
    const Texture texture = single_of(size, size, TextureFormat::rgba8, [](int i, int j, int) {
      const float shade = (i + j) % 2 == 0 ? 255 : 0;
      return std::array<float, 4>{shade, static_cast<float>(i), static_cast<float>(j), 255};
    });
    // Half a pixel to the left and down: texel (i, j) begins at the centre of pixel (i, j).
    const Placement moved{{0.5, 0.5}, {size + 0.0, size + 0.0}, {}, {1, 1}};
    const Rendering rendering =
        rasterize(textured_scene(size + 1, size + 1, texture, moved,
                                 sampler_of(Filter::nearest, MipFilter::none)),
                  {});
    ASSERT_GE(rendering.fragments.size(), static_cast<std::size_t>(size * size));
    for (const Fragment& f : rendering.fragments)
      EXPECT_EQ(pixel_of(rendering, f.x, f.y), texel_of(texture, 0, f.x % size, f.y % size))
          << size << ": " << f.x << ", " << f.y;
  }
}

// Along either axis a pixel moves by a texel in u and in v: rho is the root of 2, lambda 1/2. The
// nearest level is a tie.
TEST(TextureDrawings, DiagonalsAreATieOfLevels) {
  const Texture texture = chain_of(8, 8, TextureFormat::rgba8, [](int, int, int level) {
    return std::array<float, 4>{static_cast<float>(level), 0, 0, 255};
  });
  const Sampler sampler = sampler_of(Filter::nearest, MipFilter::nearest);
  Scene scene = textured_scene(8, 8, texture, {{0, 0}, {8, 8}, {}, {1, 1}}, sampler);
  // s = (x - y)/8, t = (x + y)/8.
  for (Vertex& vertex : scene.draws[0].vertices) {
    const auto x = static_cast<float>(vertex.position.x.to_double());
    const auto y = static_cast<float>(vertex.position.y.to_double());
    vertex.texture_coordinates = {(x - y) / 8, (x + y) / 8};
  }
  for (const auto& [choice, level] :
       {std::pair{NearestLevel::down_at_ties, 0}, std::pair{NearestLevel::up_at_ties, 1},
        std::pair{NearestLevel::even_at_ties, 0}}) {
    RuleChoices choices;
    choices.textures.nearest_level = choice;
    const TextureStage stage(scene, choices);
    for (const ScenePrimitive& primitive : primitives_of(scene)) {
      const auto attributes = attributes_of(primitive, choices, scene.target);
      const ExactLookup lookup = stage.look_up(primitive, attributes, {3, 4});
      EXPECT_EQ(lookup.lambda_prime.low, 0.5);
      EXPECT_EQ(lookup.lambda_prime.high, 0.5);
      EXPECT_EQ(lookup.accessed.low, level);
      EXPECT_EQ(to_float(middle(lookup.color[0])), to_float(level / 255.0));
    }
  }
}

// Two times and a half as small: lambda = log2(2.5), and the colour of flat levels tells it.
TEST(TextureDrawings, TrilinearColoursTellLambda) {
  const Texture texture = chain_of(16, 16, TextureFormat::rgba32f, [](int, int, int level) {
    return std::array<float, 4>{static_cast<float>(level), 0, 0.25F, 1};
  });
  const Scene scene = textured_scene(8, 8, texture, {{0, 0}, {8, 8}, {}, {1.25F, 1.25F}},
                                     sampler_of(Filter::linear, MipFilter::linear));
  const Rendering rendering = rasterize(scene, {});
  ASSERT_EQ(rendering.fragments.size(), 64U);
  for (const Fragment& f : rendering.fragments) {
    EXPECT_NEAR(f.color[0], std::log2(2.5), 1e-13);
    EXPECT_EQ(f.color[2], 0.25);
    const auto& lod = rendering.details[static_cast<std::size_t>(f.detail)].level_of_detail.value();
    EXPECT_NEAR(lod[0], std::log2(2.5), 1e-13);
    EXPECT_EQ(lod[0], lod[1]);
  }
}

// Anisotropic footprints of 4 by 1 texels: four probes, in the level of one texel. Every probe lies
// in a column of its own, their mean is that of the columns.
TEST(TextureDrawings, AnisotropicProbesStayInTheFineLevel) {
  const Texture texture = chain_of(32, 8, TextureFormat::rgba32f, [](int i, int, int level) {
    return std::array<float, 4>{static_cast<float>(i % 4 == 0), static_cast<float>(level), 0, 1};
  });
  Sampler sampler = sampler_of(Filter::nearest, MipFilter::nearest);
  sampler.max_anisotropy = 16;
  Scene scene = textured_scene(8, 8, texture, {{0, 0}, {8, 8}, {}, {1, 1}}, sampler);
  const Rendering sharp = rasterize(scene, {});
  for (const Fragment& f : sharp.fragments) {
    EXPECT_NEAR(f.color[0], 0.25, 1e-15);
    EXPECT_EQ(f.color[1], 0);
    EXPECT_EQ(sharp.details[static_cast<std::size_t>(f.detail)].level_of_detail.value()[1], 0);
  }
  scene.draws[0].texture->sampler.max_anisotropy = 1;
  for (const Fragment& f : rasterize(scene, {}).fragments) EXPECT_EQ(f.color[1], 2);
}

TEST(TextureDrawings, ExplicitLevelsAndGradients) {
  const Texture texture = chain_of(16, 16, TextureFormat::rgba32f, [](int, int, int level) {
    return std::array<float, 4>{static_cast<float>(level), 0, 0, 1};
  });
  Sampler sampler = sampler_of(Filter::nearest, MipFilter::linear);
  sampler.lod_bias = 0.5F;
  Scene scene = textured_scene(4, 4, texture, {{0, 0}, {4, 4}, {}, {1, 1}}, sampler);
  Lookup& lookup = scene.draws[0].texture->lookup;
  const auto color = [&] { return rasterize(scene, {}).fragments.at(5).color[0]; };
  EXPECT_EQ(color(), 2.5);  // 4 texels per pixel
  lookup.kind = LookupKind::bias;
  lookup.value = -1.25F;
  EXPECT_EQ(color(), 1.25);
  lookup.kind = LookupKind::lod;
  lookup.value = 3.25F;
  EXPECT_EQ(color(), 3.75);
  lookup.kind = LookupKind::gradients;
  lookup.dx = {0, 0.125F};
  lookup.dy = {-0.0625F, 0};
  EXPECT_EQ(color(), 1.5);
}

TEST(TextureDrawings, GeneratedChainsAreReported) {
  Texture texture = single_of(4, 4, TextureFormat::rgba8, [](int i, int j, int) {
    const float shade = (i + j) % 2 == 0 ? 100 : 0;
    return std::array<float, 4>{shade, 0, 0, 255};
  });
  texture.generated = true;
  const Scene scene = textured_scene(2, 2, texture, {{0, 0}, {2, 2}, {}, {1, 1}},
                                     sampler_of(Filter::nearest, MipFilter::nearest));
  const Rendering rendering = rasterize(scene, {});
  ASSERT_EQ(rendering.mip_chains.size(), 1U);
  ASSERT_EQ(rendering.mip_chains.at(0).size(), 3U);
  for (const float shade :
       {rendering.mip_chains.at(0)[1].texels[0], rendering.mip_chains.at(0)[2].texels[0]})
    EXPECT_EQ(shade, 50);
  EXPECT_EQ(pixel_of(rendering, 1, 0), (std::array{50, 0, 0, 255}));

  // What another renderer made of it.
  const RuleChoices choices;
  TextureStage stage(scene, choices);
  auto chains = stage.chains();
  for (float& component : chains[0][1].texels) component = 255;
  stage.take_chains(chains);
  const ScenePrimitive primitive = primitives_of(scene).at(0);
  const auto attributes = attributes_of(primitive, choices, scene.target);
  EXPECT_EQ(stage.look_up(primitive, attributes, {0, 0}).color[1].high, 1);
  EXPECT_EQ(stage.chains().at(0)[1].texels[0], 255);
}

// Flat coordinates have no derivative: rho is 0, and the texture magnified.
TEST(TextureDrawings, FlatCoordinatesShowOneTexel) {
  const Texture texture = chain_of(4, 4, TextureFormat::rgba8, distinct);
  Scene scene = textured_scene(4, 4, texture, {{0, 0}, {4, 4}, {0.375F, 0.375F}, {0.625F, 0.875F}},
                               sampler_of(Filter::nearest, MipFilter::linear));
  scene.draws[0].interpolation = Interpolation::flat;
  const Rendering rendering = rasterize(scene, {});
  ASSERT_EQ(rendering.fragments.size(), 16U);
  for (const Fragment& f : rendering.fragments)
    EXPECT_EQ(pixel_of(rendering, f.x, f.y), texel_of(texture, 0, f.primitive == 0 ? 1 : 2, 3));
}

TEST(TextureDrawings, UntexturedDrawsShowTheirColours) {
  const Texture texture = single_of(2, 2, TextureFormat::rgba8, distinct);
  Scene scene = textured_scene(4, 4, texture, {{0, 0}, {4, 4}, {}, {1, 1}}, {});
  scene.draws[0].texture.reset();
  const Rendering rendering = rasterize(scene, {});
  Scene plain = scene;
  plain.textures.clear();
  EXPECT_EQ(rendering.pixels, rasterize(plain, {}).pixels);
  EXPECT_TRUE(scene.details.texture);
  EXPECT_TRUE(rendering.details.empty());
}

TEST(TextureDrawings, ComparisonsGetWhatWasLookedUpAndNothingElse) {
  const Texture texture = chain_of(8, 8, TextureFormat::rgba8, distinct);
  Scene scene = textured_scene(4, 4, texture, {{0, 0}, {4, 4}, {}, {1, 2}},
                               sampler_of(Filter::linear, MipFilter::linear));
  scene.draws.push_back(scene.draws[0]);
  scene.draws[1].texture.reset();
  scene.details = {true, true, true};
  const Rendering all = rasterize(scene, {});
  const Rendering compared = rasterize_for_comparison(scene, {});
  ASSERT_EQ(compared.fragments.size(), all.fragments.size());
  ASSERT_EQ(compared.details.size(), 16U);
  for (std::size_t i = 0; i < all.fragments.size(); ++i) {
    const Fragment& f = compared.fragments[i];
    EXPECT_EQ(f.color, all.fragments[i].color);
    if (f.primitive > 1) {
      EXPECT_EQ(f.detail, -1);
      continue;
    }
    const FragmentDetail& known = all.details[static_cast<std::size_t>(all.fragments[i].detail)];
    const FragmentDetail& kept = compared.details[static_cast<std::size_t>(f.detail)];
    EXPECT_EQ(kept.texture_coordinates.value(), known.texture_coordinates.value());
    EXPECT_EQ(kept.level_of_detail.value(), known.level_of_detail.value());
    EXPECT_TRUE(known.coordinates && !kept.coordinates);
    EXPECT_TRUE(known.derivatives.has_any() && !kept.derivatives.has_any());
  }
}

// Distant coordinates are as exact as near ones: 2^24 + 1/4 is no float32, but a fragment's is.
TEST(TextureDrawings, DistantCoordinatesRepeat) {
  const Texture texture = single_of(3, 5, TextureFormat::rgba8, distinct);
  constexpr float kFar = 0x1p20F;
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat}) {
    const Sampler sampler = sampler_of(Filter::nearest, MipFilter::none, wrap);
    const Rendering near =
        rasterize(textured_scene(6, 6, texture, {{0, 0}, {6, 6}, {}, {1, 1}}, sampler), {});
    const Rendering far =
        rasterize(textured_scene(6, 6, texture,
                                 {{0, 0}, {6, 6}, {-kFar, kFar}, {1 - kFar, 1 + kFar}}, sampler),
                  {});
    EXPECT_EQ(near.pixels, far.pixels);
  }
}

// Far from 0 the difference of two coordinates cancels: intervals alone would know little of it.
TEST(TextureDrawings, DistantCoordinatesHaveNarrowLevels) {
  const Texture texture = chain_of(3, 5, TextureFormat::rgba8, distinct);
  constexpr float kFar = 0x1p20F;
  const Scene scene =
      textured_scene(6, 6, texture, {{0, 0}, {6, 6}, {kFar, -kFar}, {1 + kFar, 1 - kFar}},
                     sampler_of(Filter::linear, MipFilter::linear));
  const RuleChoices choices;
  const TextureStage stage(scene, choices);
  const ScenePrimitive primitive = primitives_of(scene).at(0);
  const auto attributes = attributes_of(primitive, choices, scene.target);
  // Along y: 5 texels over 6 pixels.
  const ExactLookup lookup = stage.look_up(primitive, attributes, {1, 1});
  EXPECT_NEAR(lookup.lambda_prime.low, std::log2(5.0 / 6), 1e-14);
  EXPECT_NEAR(lookup.lambda_prime.high, std::log2(5.0 / 6), 1e-14);
}

}  // namespace
}  // namespace edgecase
