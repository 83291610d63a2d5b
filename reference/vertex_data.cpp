// SPDX-License-Identifier: MIT
#include "reference/vertex_data.h"

namespace edgecase {

namespace {

// The clip coordinate that the division by w and the viewport transform take to window coordinate
// `window`. It is a float32 number, so its product with the size has at most 39 bits: multiplying
// first avoids rounding.
float to_clip(Fixed window, int origin, int size, float w) {
  const double half = size / 2.0;
  return static_cast<float>((window.to_double() - (origin + half)) * static_cast<double>(w) / half);
}

ClipPosition clip_position(const Vertex& vertex, const Viewport& viewport) {
  if (vertex.clip) return *vertex.clip;
  return {to_clip(vertex.position.x, viewport.x, viewport.width, vertex.w),
          to_clip(vertex.position.y, viewport.y, viewport.height, vertex.w),
          static_cast<float>(vertex.z.to_double() * static_cast<double>(vertex.w)), vertex.w};
}

GpuVertex gpu_vertex(const Vertex& vertex, const Draw& draw, const Viewport& viewport) {
  const ClipPosition clip = clip_position(vertex, viewport);
  const auto& [s, t] = vertex.texture_coordinates;
  const Color values = draw.texture ? Color{s, t, 0, 1} : vertex.color;
  return {
      {clip.x, clip.y, clip.z, clip.w}, {values[0], values[1], values[2], values[3]}, kNoPrimitive};
}

bool has_own_vertices(Primitive primitive) {
  return primitive == Primitive::points || primitive == Primitive::lines ||
         primitive == Primitive::triangles;
}

}  // namespace

std::vector<GpuVertex> gpu_vertices(const Scene& scene) {
  std::vector<GpuVertex> result;
  std::vector<std::size_t> first_of_draw;
  for (const Draw& draw : scene.draws) {
    first_of_draw.push_back(result.size());
    for (const Vertex& vertex : draw.vertices)
      result.push_back(gpu_vertex(vertex, draw, scene.viewport));
  }
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    const Draw& draw = *primitive.state;
    const int provoking = draw.provoking_vertex == ProvokingVertex::first
                              ? primitive.provoking_first
                              : primitive.provoking_last;
    for (int i = 0; i < vertices_of(primitive.kind); ++i) {
      if (i != provoking && !has_own_vertices(draw.primitive)) continue;
      const Vertex* vertex = primitive.vertices[static_cast<std::size_t>(i)];
      const auto place = static_cast<std::size_t>(vertex - draw.vertices.data());
      result[first_of_draw[static_cast<std::size_t>(primitive.draw)] + place].primitive =
          primitive.index;
    }
  }
  return result;
}

}  // namespace edgecase
