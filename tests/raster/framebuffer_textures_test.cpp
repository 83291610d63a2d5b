// SPDX-License-Identifier: MIT
//
// Textured scenes by kernels are to the bit those of the plain rasterizer: random ones of every
// sampler, and such as kernels look up themselves.
#include <gtest/gtest.h>

#include "raster/framebuffer.h"
#include "raster/rasterizer.h"
#include "tests/raster/random_scenes.h"
#include "tests/raster/random_textured_scenes.h"
#include "tests/raster/texture_scenes.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

// Which of the scene's triangles kernels look up; -1: the plain path draws all.
int expect_same(const Scene& scene, const Policy& policy) {
  Framebuffer framebuffer(scene.target, policy);
  const auto prepared = framebuffer.prepared(scene);
  if (!prepared) return -1;
  framebuffer.clear(scene.target.clear);
  framebuffer.draw(*prepared);
  EXPECT_EQ(framebuffer.pixels(), rasterize(scene, policy).pixels);
  return static_cast<int>(prepared->textured_triangles.size());
}

TEST(FramebufferTextures, EverySamplerAndLookup) {
  TexturedScenes scenes(share_seed(31));
  int drawn = 0;
  for (int i = 0; i < share_of(1500); ++i) {
    if (expect_same(scenes.next(), {}) >= 0) ++drawn;
    ASSERT_FALSE(testing::Test::HasFailure()) << i;
  }
  EXPECT_GT(drawn, least_of(1000));
}

// Two triangles whose coordinates turn, shrink and repeat the texture; linear filters of one level
// and of two.
Scene random_scene(RandomScenes& random) {
  RandomNumbers numbers(static_cast<unsigned>(random.below(1 << 30)));
  const int size = 8 + random.below(12);
  Scene scene = blank_scene(size, size);
  const int width = 1 << random.below(6), height = 1 << random.below(6);
  const TexelOf texels = random_texels(numbers, TextureFormat::rgba8);
  scene.textures = {
      std::make_shared<Texture>(chain_of(width, height, TextureFormat::rgba8, texels))};
  std::vector<Point> corners;
  for (int v = 0; v < 6; ++v) {
    const auto at = [&] { return Fixed::from_raw(random.below((size + 4) << 16) - (2 << 16)); };
    corners.push_back({at(), at()});
  }
  Draw draw = make_draw(Primitive::triangles, corners);
  draw.interpolation = random.below(2) == 0 ? Interpolation::smooth : Interpolation::noperspective;
  TextureUse use;
  use.sampler =
      sampler_of(Filter::linear, random.below(4) == 0 ? MipFilter::none : MipFilter::linear);
  for (Wrap& wrap : use.sampler.wrap)
    wrap = random.below(2) == 0 ? Wrap::repeat : Wrap::clamp_to_edge;
  use.sampler.lod_bias = static_cast<float>(random.below(5) - 2) / 4;
  draw.texture = use;
  for (Vertex& vertex : draw.vertices)
    for (float& coordinate : vertex.texture_coordinates)
      coordinate = static_cast<float>(random.below(4097) - 2048) / 512;
  scene.draws.push_back(draw);
  return scene;
}

TEST(FramebufferTextures, LinearFiltersByKernels) {
  RandomScenes random(share_seed(32));
  int by_kernels = 0;
  const int count = share_of(700);
  for (int i = 0; i < count; ++i) {
    by_kernels += std::max(0, expect_same(random_scene(random), {}));
    ASSERT_FALSE(testing::Test::HasFailure()) << i;
  }
  EXPECT_GT(by_kernels, count);
}

// Colours midway between two codes at every pixel, and coordinates on the centres of texels.
TEST(FramebufferTextures, TiesOfCodesAndTexels) {
  const Texture texture = chain_of(8, 8, TextureFormat::rgba8, [](int i, int j, int level) {
    const auto code = static_cast<float>((i * 5 + j * 3 + level) % 256);
    return std::array{code, code + 1, 255 * static_cast<float>((i + j) % 2), 255 - code};
  });
  int by_kernels = 0;
  for (const float scale : {1.0F, 2.0F, 1.5F, .5F, 3.0F})
    for (const float shift : {0.0F, .5F, .25F}) {
      Placement placement;
      placement.size = {8, 8};
      placement.uv = {shift / 8, shift / 8};
      placement.to = {scale + shift / 8, scale + shift / 8};
      Scene scene =
          textured_scene(8, 8, texture, placement, sampler_of(Filter::linear, MipFilter::linear));
      scene.draws[0].texture->sampler.lod_bias = shift;
      by_kernels += std::max(0, expect_same(scene, {}));
    }
  EXPECT_GT(by_kernels, 20);
}

}  // namespace
}  // namespace edgecase
