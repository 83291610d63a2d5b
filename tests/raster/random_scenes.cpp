// SPDX-License-Identifier: MIT
#include "tests/raster/random_scenes.h"

namespace edgecase {
namespace {

constexpr Primitive kPrimitives[] = {
    Primitive::points,    Primitive::lines,          Primitive::triangles,   Primitive::line_strip,
    Primitive::line_loop, Primitive::triangle_strip, Primitive::triangle_fan};

}  // namespace

Color color_of_bytes(int red, int green, int blue) {
  const auto component = [](int byte) { return static_cast<float>(byte) / 255.0f; };
  return {component(red), component(green), component(blue), 1};
}

Scene blank_scene(int width, int height) {
  Scene scene;
  scene.target.width = width;
  scene.target.height = height;
  scene.viewport = {0, 0, width, height};
  return scene;
}

Draw make_draw(Primitive primitive, std::span<const Point> positions, int salt) {
  Draw draw;
  draw.primitive = primitive;
  for (Point position : positions) {
    const int v = static_cast<int>(draw.vertices.size());
    Vertex vertex;
    vertex.position = position;
    vertex.z = Fixed::from_raw(((v + salt) % 17 - 8) * Fixed::kOne / 8);
    vertex.color = color_of_bytes(20 + (37 * v + 90) % 220, 20 + (4 * salt) % 236, 40 + v % 200);
    draw.vertices.push_back(vertex);
  }
  return draw;
}

Point RandomScenes::point(const SceneKind& kind) {
  const auto coordinate = [&] {
    const std::int64_t steps = (kind.size + 4) * Fixed::kOne / kind.step;
    const auto at = static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(steps + 1));
    return Fixed::from_raw(at * kind.step - 2 * Fixed::kOne);
  };
  return {coordinate(), coordinate()};
}

Scene RandomScenes::next(const SceneKind& kind) {
  Scene scene = blank_scene(kind.size, kind.size);
  scene.target.clear = color_of_bytes(below(10), 0, below(10));
  const int draws = 1 + below(kind.max_draws);
  for (int i = 0; i < draws; ++i) {
    const Primitive primitive = kPrimitives[below(7)];
    std::vector<Point> positions;
    for (int v = 0; v < vertices_of(kind_of(primitive)); ++v) positions.push_back(point(kind));
    // Strips, loops and fans go on for a primitive or two.
    while (is_vertex_count(primitive, positions.size() + 1) && positions.size() < 5 &&
           below(2) == 0)
      positions.push_back(point(kind));
    // Every other draw joins the one before it, as meshes do.
    if (i > 0 && positions.size() > 1 && below(2) == 0)
      positions.front() = scene.draws.back().vertices.back().position;
    Draw draw = make_draw(primitive, positions, i);
    if (kind.smooth && below(2) == 0) draw.interpolation = Interpolation::smooth;
    if (below(2) == 0) draw.provoking_vertex = ProvokingVertex::first;
    scene.draws.push_back(std::move(draw));
  }
  return scene;
}

}  // namespace edgecase
