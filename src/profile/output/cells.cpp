// SPDX-License-Identifier: MIT
#include "profile/output/output_scenes.h"

#include <algorithm>

#include "generate/scene_parts.h"

namespace edgecase {

RandomSource random_of(std::uint64_t seed, OutputStream stream, Surface surface,
                       std::uint64_t index) {
  // Windows have different scenes, so that both surfaces together show more.
  constexpr std::uint64_t kWindowStreams = 0x1000;
  return {seed,
          static_cast<std::uint64_t>(stream) + (surface == Surface::window ? kWindowStreams : 0),
          index};
}

Scene cell_scene(Surface surface) {
  return empty_scene(surface, kCellColumns);
}

Draw cell_draw() {
  Draw draw;
  draw.primitive = Primitive::triangles;
  draw.interpolation = Interpolation::flat;
  return draw;
}

void add_triangle(Draw& draw, std::size_t cell, const CellTriangle& triangle) {
  const auto column = static_cast<std::int64_t>(cell % kCellColumns);
  const auto row = static_cast<std::int64_t>(cell / kCellColumns);
  constexpr std::array<std::array<std::int64_t, 2>, 3> kQuarters{{{1, 1}, {3, 1}, {2, 3}}};
  std::array<Vertex, 3> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i].position = {Fixed::from_raw((4 * column + kQuarters[i][0]) * Fixed::kOne / 4),
                           Fixed::from_raw((4 * row + kQuarters[i][1]) * Fixed::kOne / 4)};
    corners[i].z = triangle.z[i];
    corners[i].color = triangle.color;
  }
  if (!triangle.front_facing) std::swap(corners[0], corners[1]);
  draw.vertices.insert(draw.vertices.end(), corners.begin(), corners.end());
}

CellTriangle flat_triangle(const Color& color, std::int64_t depth, bool front_facing) {
  const Fixed z = z_of_depth(depth);
  return {color, {z, z, z}, front_facing};
}

PixelPosition cell_pixel(const ScenePrimitive& primitive) {
  const Point corner = primitive.vertices[0]->position;
  return {static_cast<int>(corner.x.floor()), static_cast<int>(corner.y.floor())};
}

float code_color(std::int64_t code) {
  return static_cast<float>(code) / 255.0F;
}

Color random_codes(RandomSource& random) {
  Color color;
  for (float& component : color) component = code_color(random.below(256));
  return color;
}

}  // namespace edgecase
