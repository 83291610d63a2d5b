// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "casefile/clip_space.h"
#include "casefile/salted_colors.h"
#include "casefile/scene_reader.h"
#include "casefile/viewport.h"
#include "exact/numeral.h"

namespace edgecase {
namespace {

// The vertices of all draws, with salted colours where the file gives none. Those of textured draws
// have no use for any, and stay white.
std::vector<Draw> fill_colors(const std::vector<DrawFields>& draws, std::uint64_t hash) {
  std::vector<Draw> result;
  std::uint64_t colors_before = 0;
  for (const DrawFields& fields : draws) {
    Draw draw = fields.draw;
    draw.vertices.reserve(fields.vertices.size());
    const auto indices = salted_indices(draw.primitive, fields.vertices.size());
    for (std::size_t i = 0; i < fields.vertices.size(); ++i) {
      Vertex vertex = fields.vertices[i].vertex;
      if (!fields.vertices[i].has_color && !draw.texture)
        vertex.color = salted_primitive(hash, colors_before + indices[i]);
      draw.vertices.push_back(vertex);
    }
    if (!indices.empty()) colors_before += indices.back() + 1;
    result.push_back(std::move(draw));
  }
  return result;
}

void check_coordinate(const std::optional<Place>& place, const std::optional<Inexactness>& fault,
                      Findings& findings) {
  if (place && fault) findings.add(*place, fault->message, fault->remedy);
}

// A vertex in window coordinates reaches OpenGL as written.
void check_exactness(const VertexFields& fields, const Viewport& viewport, Findings& findings) {
  const Vertex& vertex = fields.vertex;
  const Point at = vertex.position;
  const ViewportSide columns{viewport.x, viewport.width};
  const ViewportSide rows{viewport.y, viewport.height};
  check_coordinate(fields.x, find_inexactness(at.x, columns, 'x', vertex.w), findings);
  check_coordinate(fields.y, find_inexactness(at.y, rows, 'y', vertex.w), findings);
  check_coordinate(fields.z, find_depth_inexactness(vertex.z, vertex.w), findings);
}

// Where clip coordinates land; false, and a finding, where that is out of range.
bool place_vertex(const Place& place, const Viewport& viewport, Vertex& vertex,
                  Findings& findings) {
  place_clip_vertex(viewport, vertex);
  const Point at = vertex.position;
  if (at.x.in_coordinate_range() && at.y.in_coordinate_range()) return true;
  findings.add(
      place,
      fmt::format("the vertex lands at ({}, {}), out of range", to_decimal(at.x), to_decimal(at.y)),
      fmt::format("use a viewport within -{0} to {0}", Fixed::kMaxCoordinate));
  return false;
}

void place_vertices(const std::vector<DrawFields>& draws, Scene& scene, Findings& findings) {
  for (std::size_t d = 0; d < draws.size(); ++d) {
    for (std::size_t i = 0; i < draws[d].vertices.size(); ++i) {
      const VertexFields& fields = draws[d].vertices[i];
      if (!fields.vertex.clip) {
        check_exactness(fields, scene.viewport, findings);
        continue;
      }
      Vertex& vertex = scene.draws[d].vertices[i];
      if (!place_vertex(fields.place, scene.viewport, vertex, findings) && fields.of_mesh) break;
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
  place_vertices(draws, scene, findings);
  return scene;
}

}  // namespace edgecase
