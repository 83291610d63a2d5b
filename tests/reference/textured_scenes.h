// SPDX-License-Identifier: MIT
//
// Textures and textured scenes for the tests of the OpenGL side.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "tests/reference/opengl_test.h"

namespace edgecase {

constexpr double kNear = 1e-5;
constexpr int kPixel = 256;  // in the units of make_draw

using Texel = std::array<float, 4>;

inline TextureLevel level_of(int width, int height, const std::vector<Texel>& texels) {
  TextureLevel level{width, height, {}};
  for (const Texel& texel : texels)
    level.texels.insert(level.texels.end(), texel.begin(), texel.end());
  return level;
}

inline std::shared_ptr<Texture> texture_of(TextureFormat format, TextureLevel level,
                                           int dimensions = 2) {
  auto texture = std::make_shared<Texture>();
  texture->dimensions = dimensions;
  texture->format = format;
  texture->levels = {std::move(level)};
  return texture;
}

// A whole chain of float levels, level k filled with (k, k/2, 1/4, 1).
inline std::shared_ptr<Texture> flat_levels(int width, int height, int dimensions = 2) {
  auto texture = std::make_shared<Texture>();
  texture->dimensions = dimensions;
  texture->format = TextureFormat::rgba32f;
  for (int k = 0; k < level_count(width, height); ++k) {
    const int w = level_size(width, k), h = level_size(height, k);
    const auto number = static_cast<float>(k);
    texture->levels.push_back(level_of(
        w, h, std::vector<Texel>(static_cast<std::size_t>(w * h), {number, number / 2, 0.25f, 1})));
  }
  return texture;
}

// Four texels in a row: red 0, 1, 2, 3.
inline std::shared_ptr<Texture> four_texels(int dimensions = 2) {
  return texture_of(TextureFormat::rgba32f,
                    level_of(4, 1, {{0, 0, 0, 1}, {1, 0, 0, 1}, {2, 0, 0, 1}, {3, 0, 0, 1}}),
                    dimensions);
}

class TexturedTest : public OpenGlTest {
 protected:
  // A target filled by one draw, which looks up (left + x ds, bottom + y dt) at pixel position x,
  // y.
  Scene textured(int width, int height, std::shared_ptr<const Texture> texture, TextureUse use,
                 float left, float ds, float bottom, float dt) const {
    Scene scene = blank(width, height);
    scene.textures = {std::move(texture)};
    scene.draws = {rectangle(0, 0, width * kPixel, height * kPixel)};
    scene.draws[0].interpolation = Interpolation::smooth;
    scene.draws[0].texture = use;
    for (Vertex& vertex : scene.draws[0].vertices)
      vertex.texture_coordinates = {
          left + ds * static_cast<float>(vertex.position.x.to_double()),
          bottom + dt * static_cast<float>(vertex.position.y.to_double())};
    scene.details.texture = true;
    return scene;
  }

  // `steps` texels per pixel along both axes of a square texture of `size` texels.
  Scene stepping(std::shared_ptr<const Texture> texture, TextureUse use, float steps) const {
    const float step = steps / static_cast<float>(texture->levels[0].width);
    return textured(4, 4, std::move(texture), use, 0, step, 0, step);
  }

  // The red that every fragment of a 4x4 target has.
  double level_shown(const Scene& scene) {
    const Rendering rendering = render(renderer(), scene);
    EXPECT_EQ(rendering.fragments.size(), 16u);
    if (rendering.fragments.empty()) return -1;
    for (const Fragment& fragment : rendering.fragments)
      EXPECT_EQ(fragment.color, rendering.fragments[0].color);
    EXPECT_NEAR(rendering.fragments[0].color[1], rendering.fragments[0].color[0] / 2, kNear);
    return rendering.fragments[0].color[0];
  }

  // The reds of a row of pixels that look up the middles of texels from `first` on.
  std::vector<double> texels_shown(std::shared_ptr<const Texture> texture, TextureUse use,
                                   int first, int count) {
    const Rendering rendering = render(
        renderer(),
        textured(count, 1, std::move(texture), use, static_cast<float>(first) / 4, 0.25f, 0.5f, 0));
    std::vector<double> reds;
    for (const Fragment& fragment : rendering.fragments) reds.push_back(fragment.color[0]);
    return reds;
  }

  bool queries() { return renderer().info().traits.at("level_of_detail") == "query"; }
};

inline const FragmentDetail& detail_of(const Rendering& rendering, const Fragment& fragment) {
  return rendering.details.at(static_cast<std::size_t>(fragment.detail));
}

inline TextureUse mipmapped(MipFilter mipmap, Filter filter = Filter::nearest) {
  TextureUse use;
  use.sampler.magnify = use.sampler.minify = filter;
  use.sampler.mipmap = mipmap;
  return use;
}

inline const TextureUse kNearest = mipmapped(MipFilter::none);
inline const TextureUse kTrilinear = mipmapped(MipFilter::linear, Filter::linear);

}  // namespace edgecase
