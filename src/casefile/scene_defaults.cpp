// SPDX-License-Identifier: MIT
#include "casefile/salted_colors.h"
#include "casefile/scene_reader.h"
#include "casefile/viewport.h"

namespace edgecase {
namespace {

// The vertices of all draws, with salted colours where the file gives none.
std::vector<Draw> fill_colors(const std::vector<DrawFields>& draws, std::uint64_t hash) {
  std::vector<Draw> result;
  std::uint64_t colors_before = 0;
  for (const DrawFields& fields : draws) {
    Draw draw = fields.draw;
    draw.vertices.reserve(fields.vertices.size());
    const auto indices = salted_indices(draw.primitive, fields.vertices.size());
    for (std::size_t i = 0; i < fields.vertices.size(); ++i) {
      Vertex vertex = fields.vertices[i].vertex;
      if (!fields.vertices[i].has_color)
        vertex.color = salted_primitive(hash, colors_before + indices[i]);
      draw.vertices.push_back(vertex);
    }
    if (!indices.empty()) colors_before += indices.back() + 1;
    result.push_back(std::move(draw));
  }
  return result;
}

void check_coordinate(const std::optional<Place>& place, Fixed value, ViewportSide side, char axis,
                      Findings& findings) {
  if (!place) return;
  if (const auto fault = find_inexactness(value, side, axis))
    findings.add(*place, fault->message, fault->remedy);
}

void check_exactness(const std::vector<DrawFields>& draws, const Viewport& viewport,
                     Findings& findings) {
  const ViewportSide columns{viewport.x, viewport.width};
  const ViewportSide rows{viewport.y, viewport.height};
  for (const DrawFields& draw : draws) {
    for (const VertexFields& fields : draw.vertices) {
      check_coordinate(fields.x, fields.vertex.position.x, columns, 'x', findings);
      check_coordinate(fields.y, fields.vertex.position.y, rows, 'y', findings);
    }
  }
}

}  // namespace

Scene complete_scene(const TargetFields& target, const std::vector<DrawFields>& draws,
                     const std::string& id, const Place& draws_place, Findings& findings) {
  const std::uint64_t hash = hash_of_id(id);
  Scene scene;
  scene.target = target.target;
  scene.target.clear = target.clear.value_or(salted_clear(hash));
  scene.draws = fill_colors(draws, hash);
  // Vertices of a faulty file have stand-in coordinates: nothing can be said about those.
  if (!findings.empty()) return scene;
  const std::optional<Viewport> viewport =
      target.viewport ? target.viewport : choose_viewport(scene.target, scene.draws);
  if (!viewport) {
    findings.add(draws_place,
                 "no viewport of at most 16384 pixels holds the target and all vertices",
                 "move the vertices closer together");
    return scene;
  }
  scene.viewport = *viewport;
  check_exactness(draws, scene.viewport, findings);
  return scene;
}

}  // namespace edgecase
