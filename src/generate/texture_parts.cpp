// SPDX-License-Identifier: MIT
#include "generate/texture_parts.h"

#include <cstdint>
#include <memory>
#include <utility>

#include "generate/random_shapes.h"

namespace edgecase {

Texture texture_of(ImageSize size, const TexelNumber& number) {
  Texture texture;
  texture.dimensions = size.height == 1 ? 1 : 2;
  texture.format = TextureFormat::rgba32f;
  for (int k = 0; k < level_count(size.width, size.height); ++k) {
    TextureLevel level{level_size(size.width, k), level_size(size.height, k), {}};
    for (int j = 0; j < level.height; ++j)
      for (int i = 0; i < level.width; ++i)
        for (int c = 0; c < 4; ++c) level.texels.push_back(number(k, i, c));
    texture.levels.push_back(std::move(level));
  }
  return texture;
}

Texture numbered_levels(ImageSize size) {
  return texture_of(size, [](int level, int, int component) {
    return component == 0 ? static_cast<float>(level) : 1.0f;
  });
}

Scene textured_scene(Surface surface, Texture texture) {
  Scene scene = empty_scene(surface, kTextureTarget);
  // Vertices on the target's edges lie inside it.
  scene.viewport = {-kTextureTarget / 2, -kTextureTarget / 2, 2 * kTextureTarget,
                    2 * kTextureTarget};
  scene.details.texture = true;
  scene.textures.push_back(std::make_shared<const Texture>(std::move(texture)));
  return scene;
}

Draw textured_draw(Primitive primitive, const Sampler& sampler, const Lookup& lookup) {
  Draw draw;
  draw.primitive = primitive;
  draw.interpolation = Interpolation::smooth;
  draw.texture = TextureUse{0, sampler, lookup};
  return draw;
}

Sampler sampler_of(Filter magnify, Filter minify, MipFilter mipmap) {
  Sampler sampler;
  sampler.magnify = magnify;
  sampler.minify = minify;
  sampler.mipmap = mipmap;
  return sampler;
}

Vertex textured_vertex(double x, double y, std::array<double, 2> coordinates) {
  Vertex vertex;
  vertex.position = {Fixed::from_raw(static_cast<std::int64_t>(x * Fixed::kOne)),
                     Fixed::from_raw(static_cast<std::int64_t>(y * Fixed::kOne))};
  vertex.texture_coordinates = {static_cast<float>(coordinates[0]),
                                static_cast<float>(coordinates[1])};
  return vertex;
}

void add_cell(Draw& draw, const Cell& cell, std::array<double, 2> origin, const TexelSteps& steps,
              ImageSize texture) {
  const auto corner = [&](int right, int up) {
    const double across = right * cell.side;
    const double above = up * cell.side;
    return textured_vertex(
        cell.x + across, cell.y + above,
        {origin[0] + (across * steps.dx[0] + above * steps.dy[0]) / texture.width,
         origin[1] + (across * steps.dx[1] + above * steps.dy[1]) / texture.height});
  };
  for (const auto& [right, up] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
    draw.vertices.push_back(corner(right, up));
}

double random_sign(RandomSource& random) {
  return static_cast<double>(random.sign());
}

}  // namespace edgecase
