// SPDX-License-Identifier: MIT
#include <utility>

#include "generate/scene_parts.h"
#include "profile/textures/texture_scenes.h"

namespace edgecase {

Texture texture_of(TextureFormat format, ImageSize size, int levels, const TexelNumber& number) {
  Texture texture;
  texture.dimensions = size.height == 1 ? 1 : 2;
  texture.format = format;
  const int count = levels == 0 ? level_count(size.width, size.height) : levels;
  for (int k = 0; k < count; ++k) {
    TextureLevel level{level_size(size.width, k), level_size(size.height, k), {}};
    for (int j = 0; j < level.height; ++j)
      for (int i = 0; i < level.width; ++i)
        for (int c = 0; c < 4; ++c) level.texels.push_back(number(k, i, j, c));
    texture.levels.push_back(std::move(level));
  }
  return texture;
}

Texture numbered_levels(ImageSize size) {
  return texture_of(TextureFormat::rgba32f, size, 0, [](int level, int, int, int component) {
    return component == 0 ? static_cast<float>(level) : 1.0f;
  });
}

Scene textured_scene(Surface surface, ImageSize target, Texture texture) {
  Scene scene = empty_scene(surface, target.width);
  scene.target.height = target.height;
  // Vertices on the target's edges lie inside it.
  scene.viewport = {-target.width / 2, -target.height / 2, 2 * target.width, 2 * target.height};
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
  vertex.position =
      in_sixteenths(static_cast<std::int64_t>(16 * x), static_cast<std::int64_t>(16 * y));
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

void add_draw(Scene& scene, Draw draw) {
  if (scene.textures[0]->dimensions == 1)
    for (Vertex& vertex : draw.vertices) vertex.texture_coordinates[1] = 0;
  scene.draws.push_back(std::move(draw));
}

Draw point_draw(std::size_t n, int target_width, const Sampler& sampler, const Lookup& lookup,
                std::array<double, 2> coordinates) {
  Draw draw = textured_draw(Primitive::points, sampler, lookup);
  const int at = static_cast<int>(n);
  draw.vertices.push_back(
      textured_vertex(at % target_width + 0.5, at / target_width + 0.5, coordinates));
  return draw;
}

double unit(RandomSource& random) {
  return static_cast<double>(random.below(1 << 24)) * 0x1p-24;
}

}  // namespace edgecase
