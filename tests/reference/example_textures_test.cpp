// SPDX-License-Identifier: MIT
//
// reference/examples/rasterizer.py on textures: the nearest texels of one level, worked out by
// hand, and a refusal of all else.
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <memory>

#include "tests/reference/example.h"

namespace edgecase {
namespace {

using ::testing::ElementsAre;

// A row of eight pixels over s from -1 to 3 and a texture of three columns: six texels to four
// pixels. Texel (i, j) has red i and green j.
Scene textured_row(Wrap wrap) {
  Scene scene = blank_scene(8, 1);
  scene.details.texture = true;
  Texture texture;
  texture.levels = {{3, 2, {0, 0, 0, 255, 1, 0, 0, 255, 2, 0, 0, 255,  //
                            0, 1, 0, 255, 1, 1, 0, 255, 2, 1, 0, 255}}};
  scene.textures = {std::make_shared<const Texture>(texture)};
  scene.draws = {rectangle(0, 0, 8 * 256, 256)};
  Draw& draw = scene.draws[0];
  draw.interpolation = Interpolation::smooth;
  draw.texture = TextureUse();
  draw.texture->sampler.wrap = {wrap, wrap};
  draw.texture->sampler.magnify = Filter::nearest;
  draw.texture->sampler.border = {2, 0, -1, 0.5f};
  for (Vertex& vertex : draw.vertices)
    vertex.texture_coordinates = {vertex.position.x > Fixed() ? 3.0f : -1.0f, 0.5f};
  return scene;
}

// The columns of the texels that a row shows, '#' for the border.
std::string columns(const Scene& scene) {
  const Rendering rendering = render(example(), scene);
  std::string text(8, '.');
  for (const Fragment& fragment : rendering.fragments) {
    const bool is_border = fragment.color == std::array{1.0, 0.0, 0.0, 0.5};
    text[static_cast<std::size_t>(fragment.x)] =
        is_border ? '#' : static_cast<char>('0' + std::lround(fragment.color[0] * 255));
  }
  return text;
}

// The centres lie at s = -3/4, -1/4, 1/4, ...: 3s is -9/4, -3/4, 3/4, 9/4, 15/4, 21/4, 27/4, 33/4.
TEST(Example, TexturesWrap) {
  EXPECT_EQ(columns(textured_row(Wrap::repeat)), "02020202");
  EXPECT_EQ(columns(textured_row(Wrap::mirrored_repeat)), "20022002");
  EXPECT_EQ(columns(textured_row(Wrap::clamp_to_edge)), "00022222");
  EXPECT_EQ(columns(textured_row(Wrap::clamp_to_border)), "##02####");
  const Rendering rendering = render(example(), textured_row(Wrap::repeat));
  const auto detail_of = [&](std::size_t fragment) {
    return rendering.details.at(static_cast<std::size_t>(rendering.fragments.at(fragment).detail));
  };
  EXPECT_THAT(detail_of(3).texture_coordinates.value(), ElementsAre(0.75, 0.5));
  // On the border between two rows: the upper one.
  EXPECT_THAT(pixel(rendering, 3, 0), ElementsAre(2, 1, 0, 255));
}

TEST(Example, OneDimensionalTexturesHaveOneRow) {
  Scene scene = textured_row(Wrap::clamp_to_border);
  Texture texture;
  texture.dimensions = 1;
  texture.format = TextureFormat::rgba32f;
  texture.levels = {{2, 1, {-4, 0.5f, 1e30f, 1, 7, 8, 9, 10}}};
  scene.textures = {std::make_shared<const Texture>(texture)};
  for (Vertex& vertex : scene.draws[0].vertices) vertex.texture_coordinates[1] = 5;
  const Rendering rendering = render(example(), scene);
  EXPECT_THAT(rendering.fragments.at(2).color, ElementsAre(-4, 0.5, static_cast<double>(1e30f), 1));
  EXPECT_THAT(rendering.fragments.at(3).color, ElementsAre(7, 8, 9, 10));
  EXPECT_THAT(rendering.fragments.at(4).color, ElementsAre(2, 0, -1, 0.5));
}

TEST(Example, RefusesTexturesThatItDoesNotDraw) {
  const auto reason = [](auto change) {
    Scene scene = textured_row(Wrap::repeat);
    Texture texture = *scene.textures[0];
    change(*scene.draws[0].texture, texture);
    scene.textures[0] = std::make_shared<const Texture>(texture);
    const Outcome outcome = render_outcome(example(), scene);
    const auto* failure = std::get_if<Failure>(&outcome);
    return failure == nullptr ? "" : failure->reason;
  };
  EXPECT_EQ(reason([](TextureUse&, Texture&) {}), "");
  const std::string filter = "this example looks up the nearest texel of one level";
  EXPECT_EQ(reason([](TextureUse& use, Texture&) { use.sampler.magnify = Filter::linear; }),
            filter);
  EXPECT_EQ(reason([](TextureUse& use, Texture&) { use.sampler.minify = Filter::linear; }), filter);
  EXPECT_EQ(reason([](TextureUse& use, Texture& texture) {
              texture.generated = true;
              use.sampler.mipmap = MipFilter::nearest;
            }),
            filter);
  EXPECT_EQ(reason([](TextureUse&, Texture& texture) { texture.format = TextureFormat::srgb8; }),
            "this example has no such texture");
  EXPECT_EQ(reason([](TextureUse& use, Texture& texture) {
              texture.generated = true;
              use.sampler.base_level = 1;
            }),
            "this example generates no levels");
}

}  // namespace
}  // namespace edgecase
