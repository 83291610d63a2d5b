// SPDX-License-Identifier: MIT
#include "tests/raster/clipped_scenes.h"

namespace edgecase {

Vertex clip_vertex(const ClipPosition& clip) {
  Vertex vertex;
  vertex.clip = clip;
  vertex.w = clip.w;
  return vertex;
}

Vertex ClippedScenes::vertex() {
  const auto number = [&](int limit) { return static_cast<float>(between(-limit, limit)); };
  ClipPosition clip{number(6), number(6), number(4), number(3)};
  if (clip == ClipPosition{0, 0, 0, 0}) clip.x = 1;
  Vertex vertex = clip_vertex(clip);
  vertex.color = {number(4), number(2), static_cast<float>(between(0, 1)), 1};
  return vertex;
}

Vertex ClippedScenes::vertex_inside() {
  const int w = between(1, 4);
  const auto number = [&] { return static_cast<float>(between(-w, w)); };
  return clip_vertex({number(), number(), number(), static_cast<float>(w)});
}

Scene ClippedScenes::scene(Primitive primitive, std::size_t vertices, const Viewport& viewport) {
  Scene scene;
  scene.target.width = scene.target.height = 8;
  scene.viewport = viewport;
  Draw& draw = scene.draws.emplace_back();
  draw.primitive = primitive;
  draw.interpolation = Interpolation::smooth;
  for (std::size_t i = 0; i < vertices; ++i) draw.vertices.push_back(vertex());
  return scene;
}

}  // namespace edgecase
