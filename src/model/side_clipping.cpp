// SPDX-License-Identifier: MIT
#include "model/side_clipping.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "model/clipped_line.h"

namespace edgecase {
namespace {

bool leaves_sides(const Vertex& vertex) {
  // Window positions lie within the viewport.
  if (!vertex.clip) return false;
  const ClipPosition& clip = *vertex.clip;
  return !(std::fabs(clip.x) <= clip.w && std::fabs(clip.y) <= clip.w);
}

bool is_in_range(const HomogeneousPoint& place) {
  const std::int64_t limit = Fixed::kMaxCoordinate * place.w;
  return place.w > 0 && std::abs(place.x) <= limit && std::abs(place.y) <= limit;
}

// Whether some of a line that is not cut at the sides is left, which may run to infinity.
bool is_seen(const ScenePrimitive& line) {
  return is_partly_inside(rational_clip(*line.vertices[0], line.viewport),
                          rational_clip(*line.vertices[1], line.viewport), line.clips_sides);
}

// Of a primitive that is clipped without sides.
bool has_exact_places(const ScenePrimitive& primitive) {
  if (primitive.is_clipped) return primitive.kind == PrimitiveKind::point || !is_seen(primitive);
  return std::all_of(primitive.positions.begin(),
                     primitive.positions.begin() + vertices_of(primitive.kind), is_in_range);
}

}  // namespace

bool leaves_sides(const ScenePrimitive& primitive) {
  return primitive.kind != PrimitiveKind::triangle &&
         std::any_of(primitive.vertices.begin(),
                     primitive.vertices.begin() + vertices_of(primitive.kind),
                     [](const Vertex* vertex) { return leaves_sides(*vertex); });
}

bool leaves_sides(const Scene& scene) {
  return std::ranges::any_of(scene.draws, [](const Draw& draw) {
    return kind_of(draw.primitive) != PrimitiveKind::triangle &&
           std::ranges::any_of(draw.vertices,
                               [](const Vertex& vertex) { return leaves_sides(vertex); });
  });
}

std::optional<ScenePrimitive> of_other_api(const ScenePrimitive& primitive) {
  const ScenePrimitive other = with_sides(primitive, !primitive.clips_sides);
  if (!other.clips_sides && !has_exact_places(other)) return std::nullopt;
  return other;
}

SceneOfApi::SceneOfApi(const Scene& scene, bool is_es) : given_(&scene) {
  if (!is_es || !leaves_sides(scene)) return;
  own_ = scene;
  own_->clips_sides = false;
  is_exact_ = std::ranges::all_of(primitives_of(*own_), [](const ScenePrimitive& primitive) {
    return !leaves_sides(primitive) || has_exact_places(primitive);
  });
}

}  // namespace edgecase
