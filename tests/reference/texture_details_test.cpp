// SPDX-License-Identifier: MIT
//
// What is told of textured scenes on the OpenGL side: that it belongs to its fragment, its draw and
// its texture.
#include <gmock/gmock.h>

#include <optional>

#include "tests/reference/textured_scenes.h"

namespace edgecase {
namespace {

using ::testing::Each;

class TextureDetailsTest : public TexturedTest {};

TEST_P(TextureDetailsTest, ALevelOfDetailIsToldOfImplicitLookupsAlone) {
  TextureUse use = kTrilinear;
  const Rendering implicit = render(renderer(), stepping(flat_levels(64, 64), use, 0.5f));
  ASSERT_EQ(implicit.details.size(), 16u);
  for (const FragmentDetail& detail : implicit.details) {
    EXPECT_TRUE(detail.texture_coordinates.has_value());
    ASSERT_EQ(detail.level_of_detail.has_value(), queries());
    if (!queries()) continue;
    EXPECT_NEAR(detail.level_of_detail.value()[0], 0, kNear);
    EXPECT_NEAR(detail.level_of_detail.value()[1], -1, kNear);
  }
  use.lookup = {LookupKind::lod, 1, {}, {}};
  const Rendering told = render(renderer(), stepping(flat_levels(64, 64), use, 0.5f));
  for (const FragmentDetail& detail : told.details)
    EXPECT_FALSE(detail.level_of_detail.has_value());
}

TEST_P(TextureDetailsTest, DerivativesAreThoseOfTheTextureCoordinates) {
  Scene scene = textured(8, 8, four_texels(), kNearest, 0, 0.25f, 0, -2);
  scene.details = {false, true, true};
  const Rendering rendering = render(renderer(), scene);
  ASSERT_EQ(rendering.details.size(), 64u);
  for (const FragmentDetail& detail : rendering.details) {
    EXPECT_FALSE(detail.coordinates.has_value());
    for (std::size_t i = 0; i < kDerivatives; ++i) {
      const bool along_x = i % 2 == 0;
      EXPECT_NEAR(detail.derivatives[i].value()[0], along_x ? 0.25 : 0, kNear);
      EXPECT_NEAR(detail.derivatives[i].value()[1], along_x ? 0 : -2, kNear);
      EXPECT_NEAR(detail.derivatives[i].value()[2], 0, kNear);
    }
  }
}

TEST_P(TextureDetailsTest, DrawsOfASceneAreTexturedOrNotEachForItself) {
  // More textures than are kept, of both dimensions, every fifth draw without one.
  constexpr int kDraws = 40;
  Scene scene = blank(kDraws, 1);
  scene.details.texture = true;
  for (int x = 0; x < kDraws; ++x) {
    const auto value = static_cast<float>(x);
    Draw draw = rectangle(x * kPixel, 0, (x + 1) * kPixel, kPixel, {value, 0.5f, 0, 1});
    if (x % 5 != 0) {
      draw.texture = kNearest;
      draw.texture->texture = scene.textures.size();
      scene.textures.push_back(
          texture_of(TextureFormat::rgba32f, level_of(1, 1, {{100 + value, 0, 0, 1}}), 1 + x % 2));
    }
    scene.draws.push_back(std::move(draw));
  }
  for (int repetition = 0; repetition < 2; ++repetition) {
    const Rendering rendering = render(renderer(), scene);
    ASSERT_EQ(rendering.fragments.size(), static_cast<std::size_t>(kDraws));
    for (const Fragment& fragment : rendering.fragments) {
      const bool is_textured = fragment.x % 5 != 0;
      EXPECT_EQ(fragment.color[0], (is_textured ? 100 : 0) + fragment.x);
      // Of a fragment without a texture there is nothing to tell.
      ASSERT_EQ(fragment.detail >= 0, is_textured);
      if (!is_textured) continue;
      EXPECT_TRUE(detail_of(rendering, fragment).texture_coordinates.has_value());
      EXPECT_EQ(detail_of(rendering, fragment).level_of_detail.has_value(), queries());
    }
  }
}

TEST_P(TextureDetailsTest, TexturesThatDifferInOneNumberAreNotTakenForEachOther) {
  Texel texel{0.5f, -0.0f, 0, 1};
  for (const float green : {-0.0f, 0.0f, 1e-40f, 0.25f}) {
    texel[1] = green;
    const Rendering rendering = render(
        renderer(), textured(1, 1, texture_of(TextureFormat::rgba32f, level_of(1, 1, {texel})),
                             kNearest, 0, 1, 0, 1));
    ASSERT_EQ(rendering.fragments.size(), 1u);
    if (green != 1e-40f) {  // which a driver may flush to zero
      EXPECT_EQ(rendering.fragments[0].color[1], static_cast<double>(green));
    }
  }
}

TEST_P(TextureDetailsTest, PixelsAndCapturedColoursAgree) {
  std::vector<Texel> texels;
  for (int i = 0; i < 64; ++i) {
    const auto code = [&](int factor) { return static_cast<float>(i * factor % 256); };
    texels.push_back({code(37), code(91), code(151), code(211)});
  }
  for (TextureFormat format : {TextureFormat::rgba8, TextureFormat::srgb8}) {
    TextureUse use = mipmapped(MipFilter::none, Filter::linear);
    const Scene scene = textured(16, 16, texture_of(format, level_of(8, 8, texels)), use, 0.1f,
                                 0.03f, -0.2f, 0.07f);
    const Rendering rendering = render(renderer(), scene);
    ASSERT_EQ(rendering.fragments.size(), 256u);
    for (const Fragment& fragment : rendering.fragments)
      for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(pixel(rendering, fragment.x, fragment.y)[i], 255 * fragment.color[i], 0.51);
  }
}

TEST_P(TextureDetailsTest, GeneratedChainsAreToldInTheTexturesUnits) {
  const std::pair<TextureFormat, Texel> kinds[] = {{TextureFormat::rgba8, {200, 3, 77, 128}},
                                                   {TextureFormat::srgb8, {0, 255, 255, 128}},
                                                   {TextureFormat::rgba32f, {-3, 0.5f, 1e20f, 1}}};
  for (const auto& [format, texel] : kinds) {
    for (int dimensions : {1, 2}) {
      SCOPED_TRACE(name_of(format));
      const int height = dimensions == 1 ? 1 : 5;
      auto texture = texture_of(
          format,
          level_of(12, height, std::vector<Texel>(static_cast<std::size_t>(12 * height), texel)),
          dimensions);
      texture->generated = true;
      Scene scene = textured(4, 4, four_texels(), kNearest, 0, 1, 0, 1);
      scene.textures.push_back(texture);
      const Rendering rendering = render(renderer(), scene);
      ASSERT_EQ(rendering.mip_chains.size(), 1u);
      const auto& chain = rendering.mip_chains.at(1);
      ASSERT_EQ(chain.size(), 4u);
      for (std::size_t k = 0; k < chain.size(); ++k) {
        EXPECT_EQ(chain[k].width, 12 >> k | (k == 3 ? 1 : 0));
        EXPECT_EQ(chain[k].height, std::max(1, height >> k));
        ASSERT_EQ(chain[k].texels.size(), chain[k].index(0, chain[k].height));
        for (std::size_t i = 0; i < chain[k].texels.size(); ++i)
          EXPECT_EQ(chain[k].texels[i], texel[i % 4]);
      }
      // A given chain is not told, and neither is anything where coverage alone is asked for.
      const Task task{"test", &scene, true};
      std::optional<Outcome> outcome;
      renderer().render({&task, 1}, [&](std::size_t, Outcome got) { outcome = std::move(got); });
      ASSERT_TRUE(outcome && std::holds_alternative<Rendering>(*outcome));
      EXPECT_TRUE(std::get<Rendering>(*outcome).mip_chains.empty());
    }
  }
}

TEST_P(TextureDetailsTest, ASceneWithoutTexturedDrawsHasNoTextureDetails) {
  Scene scene = textured(2, 2, four_texels(), kNearest, 0, 1, 0, 1);
  scene.draws[0].texture.reset();
  scene.details.derivatives = true;
  const Rendering rendering = render(renderer(), scene);
  ASSERT_EQ(rendering.details.size(), 4u);
  for (const FragmentDetail& detail : rendering.details) {
    EXPECT_FALSE(detail.texture_coordinates.has_value());
    EXPECT_FALSE(detail.level_of_detail.has_value());
  }
  for (const Fragment& fragment : rendering.fragments) EXPECT_THAT(fragment.color, Each(1.0));
}

INSTANTIATE_TEST_SUITE_P(OpenGl, TextureDetailsTest, EDGECASE_ALL_PLACES, place_name);

}  // namespace
}  // namespace edgecase
