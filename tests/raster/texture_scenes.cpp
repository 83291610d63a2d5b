// SPDX-License-Identifier: MIT
#include "tests/raster/texture_scenes.h"

#include "tests/raster/random_scenes.h"
#include "tests/support/points.h"

namespace edgecase {

TextureLevel level_of(int width, int height, int level, const TexelOf& texel) {
  TextureLevel result{width, height, {}};
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i)
      for (const float component : texel(i, j, level)) result.texels.push_back(component);
  return result;
}

Texture chain_of(int width, int height, TextureFormat format, const TexelOf& texel) {
  Texture texture;
  texture.format = format;
  for (int level = 0; level < level_count(width, height); ++level)
    texture.levels.push_back(
        level_of(level_size(width, level), level_size(height, level), level, texel));
  return texture;
}

Texture single_of(int width, int height, TextureFormat format, const TexelOf& texel) {
  Texture texture;
  texture.format = format;
  texture.levels = {level_of(width, height, 0, texel)};
  return texture;
}

std::array<float, 4> distinct(int i, int j, int level) {
  return {static_cast<float>(i), static_cast<float>(j), static_cast<float>(20 * level),
          static_cast<float>((37 * i + 101 * j) % 256)};
}

TexelOf random_texels(RandomNumbers& numbers, TextureFormat format) {
  return [&numbers, format](int, int, int) {
    std::array<float, 4> texel{};
    for (float& component : texel)
      component = format == TextureFormat::rgba32f ? static_cast<float>(numbers.attribute(100))
                                                   : static_cast<float>(numbers.integer(0, 255));
    return texel;
  };
}

Scene textured_scene(int width, int height, const Texture& texture, const Placement& place,
                     const Sampler& sampler) {
  Scene scene = blank_scene(width, height);
  scene.details.texture = true;
  scene.textures = {std::make_shared<const Texture>(texture)};
  const double x0 = place.at[0], y0 = place.at[1];
  const double x1 = x0 + place.size[0], y1 = y0 + place.size[1];
  const Point corners[] = {at(x0, y0), at(x1, y0), at(x0, y1), at(x1, y1)};
  Draw draw = make_draw(Primitive::triangle_strip, corners);
  draw.interpolation = Interpolation::smooth;
  draw.texture = TextureUse{0, sampler, {}};
  for (std::size_t v = 0; v < 4; ++v)
    draw.vertices[v].texture_coordinates = {v % 2 == 0 ? place.uv[0] : place.to[0],
                                            v < 2 ? place.uv[1] : place.to[1]};
  scene.draws = {draw};
  return scene;
}

Sampler sampler_of(Filter filter, MipFilter mipmap, Wrap wrap) {
  Sampler sampler;
  sampler.magnify = sampler.minify = filter;
  sampler.mipmap = mipmap;
  sampler.wrap = {wrap, wrap};
  return sampler;
}

}  // namespace edgecase
