// SPDX-License-Identifier: MIT
//
// Textures on the OpenGL side: not how exact a driver filters, but that what a scene says of its
// textures, samplers and lookups reaches the driver.
#include <gmock/gmock.h>

#include <cmath>

#include "tests/reference/textured_scenes.h"

namespace edgecase {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class TexturesTest : public TexturedTest {};

TEST_P(TexturesTest, ATexelPerPixelShowsTheImage) {
  std::vector<Texel> texels;
  for (int i = 0; i < 15; ++i)
    texels.push_back(
        {static_cast<float>(17 * i), static_cast<float>(255 - i), static_cast<float>(i), 255});
  const auto texture = texture_of(TextureFormat::rgba8, level_of(5, 3, texels));
  const Rendering rendering =
      render(renderer(), textured(5, 3, texture, kNearest, 0, 0.2f, 0, 1.0f / 3));
  ASSERT_EQ(rendering.fragments.size(), 15u);
  for (std::size_t i = 0; i < 15; ++i) {
    const Fragment& fragment = rendering.fragments[i];
    EXPECT_THAT(pixel(rendering, fragment.x, fragment.y),
                ElementsAre(texels[i][0], texels[i][1], texels[i][2], 255));
    EXPECT_NEAR(fragment.color[0] * 255, static_cast<double>(texels[i][0]), 1e-3);
    const auto& at = detail_of(rendering, fragment).texture_coordinates.value();
    EXPECT_NEAR(at[0], (fragment.x + 0.5) / 5, kNear);
    EXPECT_NEAR(at[1], (fragment.y + 0.5) / 3, kNear);
  }
}

TEST_P(TexturesTest, FloatsComeAsTheyAreAndSrgbIsDecoded) {
  const auto floats =
      texture_of(TextureFormat::rgba32f, level_of(1, 1, {{-2.5f, 1000, 3e38f, 1e-30f}}));
  const Rendering as_is = render(renderer(), textured(1, 1, floats, kNearest, 0, 1, 0, 1));
  ASSERT_EQ(as_is.fragments.size(), 1u);
  EXPECT_THAT(as_is.fragments[0].color,
              ElementsAre(-2.5, 1000, static_cast<double>(3e38f), static_cast<double>(1e-30f)));
  const auto codes = texture_of(TextureFormat::srgb8, level_of(1, 1, {{0, 128, 255, 128}}));
  const Rendering decoded = render(renderer(), textured(1, 1, codes, kNearest, 0, 1, 0, 1));
  ASSERT_EQ(decoded.fragments.size(), 1u);
  const auto& color = decoded.fragments[0].color;
  EXPECT_EQ(color[0], 0);
  // Drivers decode by polynomials. The codes beside this one are 0.0037 away.
  EXPECT_NEAR(color[1], std::pow((128.0 / 255 + 0.055) / 1.055, 2.4), 0.001);
  EXPECT_NEAR(color[2], 1, kNear);
  EXPECT_NEAR(color[3], 128.0 / 255, kNear);
}

TEST_P(TexturesTest, WrapsAsTheSamplerSays) {
  for (int dimensions : {1, 2}) {
    TextureUse use = kNearest;
    use.sampler.border = {9, 0, 0, 1};
    const auto shown = [&](Wrap wrap) {
      use.sampler.wrap = {wrap, Wrap::clamp_to_edge};
      return texels_shown(four_texels(dimensions), use, -5, 14);
    };
    EXPECT_THAT(shown(Wrap::repeat), ElementsAre(3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0));
    EXPECT_THAT(shown(Wrap::mirrored_repeat),
                ElementsAre(3, 3, 2, 1, 0, 0, 1, 2, 3, 3, 2, 1, 0, 0));
    EXPECT_THAT(shown(Wrap::clamp_to_edge), ElementsAre(0, 0, 0, 0, 0, 0, 1, 2, 3, 3, 3, 3, 3, 3));
    EXPECT_THAT(shown(Wrap::clamp_to_border),
                ElementsAre(9, 9, 9, 9, 9, 0, 1, 2, 3, 9, 9, 9, 9, 9));
  }
}

TEST_P(TexturesTest, WrapsOfSAndTAreTheirOwn) {
  const auto texture =
      texture_of(TextureFormat::rgba32f,
                 level_of(2, 2, {{0, 0, 0, 1}, {1, 0, 0, 1}, {2, 0, 0, 1}, {3, 0, 0, 1}}));
  TextureUse use = kNearest;
  use.sampler.wrap = {Wrap::repeat, Wrap::clamp_to_edge};
  const Rendering rendering =
      render(renderer(), textured(4, 4, texture, use, 0, 0.5f, -0.5f, 0.5f));
  std::vector<double> reds;
  for (const Fragment& fragment : rendering.fragments) reds.push_back(fragment.color[0]);
  EXPECT_THAT(reds, ElementsAre(0, 1, 0, 1, 0, 1, 0, 1, 2, 3, 2, 3, 2, 3, 2, 3));
}

TEST_P(TexturesTest, FiltersAreThoseOfMagnificationAndMinification) {
  for (int dimensions : {1, 2}) {
    for (const bool magnified : {true, false}) {
      TextureUse use;
      use.sampler.magnify = magnified ? Filter::linear : Filter::nearest;
      use.sampler.minify = magnified ? Filter::nearest : Filter::linear;
      // Three quarters of the way from the middle of one texel to the next; the level of detail is
      // told, so that the filter does not hang on it being computed.
      use.lookup = {LookupKind::lod, magnified ? -1.0f : 1.0f, {}, {}};
      const Scene scene = textured(1, 1, four_texels(dimensions), use, 0.3125f, 0, 0.5f, 0);
      const Rendering rendering = render(renderer(), scene);
      ASSERT_EQ(rendering.fragments.size(), 1u);
      EXPECT_EQ(rendering.fragments[0].color[0], 0.75) << dimensions << magnified;
      use.lookup.value = -use.lookup.value;
      const Rendering other =
          render(renderer(), textured(1, 1, four_texels(dimensions), use, 0.3125f, 0, 0.5f, 0));
      ASSERT_EQ(other.fragments.size(), 1u);
      EXPECT_EQ(other.fragments[0].color[0], 1) << dimensions << magnified;
    }
  }
}

TEST_P(TexturesTest, EveryKindOfLookupReachesItsLevel) {
  for (int dimensions : {1, 2}) {
    const auto texture = flat_levels(64, dimensions == 1 ? 1 : 64, dimensions);
    TextureUse use = kTrilinear;
    EXPECT_NEAR(level_shown(stepping(texture, use, 4)), 2, kNear);
    use.lookup = {LookupKind::bias, 1.5f, {}, {}};
    EXPECT_NEAR(level_shown(stepping(texture, use, 4)), 3.5, kNear);
    use.lookup = {LookupKind::lod, 3.25f, {}, {}};
    EXPECT_NEAR(level_shown(stepping(texture, use, 4)), 3.25, kNear);
    // Powers of two, where every approximation of a logarithm is exact.
    use.lookup = {LookupKind::gradients, 0, {0, 1.0f / 64}, {8.0f / 64, 0}};
    EXPECT_NEAR(level_shown(stepping(texture, use, 4)), 3, kNear);
    use.lookup = {LookupKind::gradients, 0, {2.0f / 64, 0}, {0, 1.0f / 64}};
    EXPECT_NEAR(level_shown(stepping(texture, use, 4)), 1, kNear);
  }
  TextureUse use = kTrilinear;
  use.lookup = {LookupKind::gradients, 0, {0, 4.0f / 64}, {1.0f / 64, 0}};
  EXPECT_NEAR(level_shown(stepping(flat_levels(64, 64), use, 1)), 2, kNear);
}

TEST_P(TexturesTest, LevelsObeyTheSampler) {
  const auto texture = flat_levels(64, 64);
  const auto shown = [&](auto change, float steps = 4) {
    TextureUse use = kTrilinear;
    change(use.sampler);
    return level_shown(stepping(texture, use, steps));
  };
  EXPECT_NEAR(shown([](Sampler& s) { s.lod_bias = 1.25f; }), 3.25, kNear);
  EXPECT_NEAR(shown([](Sampler& s) { s.min_lod = 2.75f; }), 2.75, kNear);
  EXPECT_NEAR(shown([](Sampler& s) { s.max_lod = 1.5f; }), 1.5, kNear);
  EXPECT_NEAR(shown([](Sampler& s) { s.base_level = 3; }, 1), 3, kNear);
  EXPECT_NEAR(shown([](Sampler& s) { s.base_level = 1; }, 8), 3, kNear);
  EXPECT_NEAR(shown([](Sampler& s) { s.max_level = 1; }), 1, kNear);
  EXPECT_NEAR(shown([](Sampler& s) { s.mipmap = MipFilter::none; }), 0, kNear);
  // Two draws in turn: neither keeps what the other had set.
  EXPECT_NEAR(shown([](Sampler&) {}, 16), 4, kNear);
  EXPECT_NEAR(shown([](Sampler& s) {
                s.mipmap = MipFilter::nearest;
                s.lod_bias = 0.75f;
              }),
              3, kNear);
}

TEST_P(TexturesTest, GeneratedLevelsAreLookedUp) {
  std::vector<Texel> texels;
  for (int i = 0; i < 16; ++i) texels.push_back({static_cast<float>(i), 0, 0, 1});
  auto texture = texture_of(TextureFormat::rgba32f, level_of(4, 4, texels));
  texture->generated = true;
  TextureUse use = mipmapped(MipFilter::nearest);
  use.lookup = {LookupKind::lod, 1, {}, {}};
  const Rendering rendering = render(renderer(), textured(2, 2, texture, use, 0, 0.5f, 0, 0.5f));
  ASSERT_EQ(rendering.fragments.size(), 4u);
  const auto& chain = rendering.mip_chains.at(0);
  ASSERT_EQ(chain.size(), 3u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(rendering.fragments[i].color[0], static_cast<double>(chain[1].texels[4 * i]));
}

TEST_P(TexturesTest, AnisotropyBeyondTheDriversIsRefusedAndElseDrawn) {
  TextureUse use = kTrilinear;
  use.sampler.max_anisotropy = 16;
  const double most = std::stod(renderer().info().traits.at("max_anisotropy"));
  const Outcome outcome = render_outcome(
      renderer(), textured(4, 4, flat_levels(64, 64), use, 0, 1.0f / 64, 0, 16.0f / 64));
  if (most < 16) {
    ASSERT_TRUE(std::holds_alternative<Failure>(outcome));
    EXPECT_THAT(std::get<Failure>(outcome).reason, HasSubstr("anisotrop"));
    return;
  }
  // One texel per pixel along one axis and 16 along the other: without it, this is level 4.
  ASSERT_TRUE(std::holds_alternative<Rendering>(outcome));
  for (const Fragment& fragment : std::get<Rendering>(outcome).fragments)
    EXPECT_LT(fragment.color[0], 1);
}

INSTANTIATE_TEST_SUITE_P(OpenGl, TexturesTest, EDGECASE_ALL_PLACES, place_name);

}  // namespace
}  // namespace edgecase
