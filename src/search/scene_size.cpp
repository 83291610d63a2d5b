// SPDX-License-Identifier: MIT
#include "search/scene_size.h"

#include <algorithm>
#include <bit>
#include <set>

#include "search/settings.h"

namespace edgecase {
namespace {

std::int64_t magnitude(Fixed value) {
  return value.raw() < 0 ? -value.raw() : value.raw();
}

bool is_joined(Primitive primitive) {
  return primitive != Primitive::points && primitive != Primitive::lines &&
         primitive != Primitive::triangles;
}

// The total of numeric settings. A setting that is given counts by itself, so this only has to
// distinguish less of it from more.
std::int64_t extent_of(const Scene& scene) {
  std::int64_t extent =
      scene.target.samples + static_cast<std::int64_t>(scene.supersampling.size());
  for (const auto& texture : scene.textures)
    for (const TextureLevel& level : texture->levels)
      extent += static_cast<std::int64_t>(level.texels.size());
  for (const Draw& draw : scene.draws) {
    for (const Fixed value : {draw.line_width, draw.point_size})
      extent += fraction_bits_of(value) + value.ceil();
    extent += std::ranges::count_if(draw.vertices, [&](const Vertex& vertex) {
      return vertex.color != draw.vertices.front().color;
    });
    if (draw.scissor) extent += draw.scissor->width + draw.scissor->height;
  }
  return extent;
}

void add_coordinates(const Scene& scene, SceneSize& size) {
  std::set<Fixed> columns;
  std::set<Fixed> rows;
  for (const Draw& draw : scene.draws) {
    for (const Vertex& vertex : draw.vertices) {
      columns.insert(vertex.position.x);
      rows.insert(vertex.position.y);
      for (const Fixed value : {vertex.position.x, vertex.position.y, vertex.z}) {
        size.all_bits += fraction_bits_of(value);
        size.distance += magnitude(value);
      }
    }
  }
  size.values = static_cast<std::int64_t>(columns.size() + rows.size());
}

}  // namespace

int fraction_bits_of(Fixed value) {
  if (value.raw() == 0) return 0;
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(value.raw()));
  return Fixed::kFractionBits - std::min(Fixed::kFractionBits, zeros);
}

int fraction_bits_of(const Scene& scene) {
  int most = 0;
  for (const Draw& draw : scene.draws)
    for (const Vertex& vertex : draw.vertices)
      for (const Fixed value : {vertex.position.x, vertex.position.y, vertex.z})
        most = std::max(most, fraction_bits_of(value));
  return most;
}

SceneSize size_of(const Scene& scene) {
  SceneSize size;
  size.primitives = static_cast<std::int64_t>(primitives_of(scene).size());
  size.draws = static_cast<std::int64_t>(scene.draws.size());
  size.joined = std::ranges::count_if(scene.draws,
                                      [](const Draw& draw) { return is_joined(draw.primitive); });
  size.settings = count_settings(scene);
  size.extent = extent_of(scene);
  size.fraction_bits = fraction_bits_of(scene);
  size.pixels = std::int64_t{scene.target.width} * scene.target.height;
  size.sides = scene.target.width + scene.target.height;
  add_coordinates(scene, size);
  return size;
}

}  // namespace edgecase
