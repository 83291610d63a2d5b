// SPDX-License-Identifier: MIT
#include "generate/scene_parts.h"

namespace edgecase {
namespace {

// Four levels per channel give 63 distinct colours: index + 1 in base 4.
Color color_of(std::size_t index) {
  const std::size_t code = index % 63 + 1;
  const auto channel = [&](int digit) {
    return static_cast<float>((code >> (2 * digit) & 3) * 85) / 255.0f;
  };
  return {channel(0), channel(1), channel(2), 1};
}

}  // namespace

Scene empty_scene(Surface surface, int size) {
  Scene scene;
  scene.target.width = size;
  scene.target.height = size;
  scene.target.surface = surface;
  scene.viewport = {0, 0, size, size};
  return scene;
}

Draw colored_draw(Primitive primitive, std::span<const Point> positions) {
  Draw draw;
  draw.primitive = primitive;
  for (std::size_t i = 0; i < positions.size(); ++i)
    draw.vertices.push_back({positions[i], Fixed(), color_of(i)});
  return draw;
}

Scene scene_of(Surface surface, int size, Primitive primitive, std::span<const Point> positions) {
  Scene scene = empty_scene(surface, size);
  scene.draws.push_back(colored_draw(primitive, positions));
  return scene;
}

bool strictly_inside(Point point, int size) {
  const Fixed end = Fixed::from_integer(size);
  return point.x > Fixed() && point.x < end && point.y > Fixed() && point.y < end;
}

}  // namespace edgecase
