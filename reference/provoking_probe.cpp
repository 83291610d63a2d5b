// SPDX-License-Identifier: MIT
#include "reference/provoking_probe.h"

#include <algorithm>
#include <string>

#include "reference/scene_renderer.h"

namespace edgecase {

Scene provoking_scene(Primitive primitive, ProvokingVertex which) {
  constexpr int kSize = 4;  // pixels
  constexpr int kCorners[][2] = {{0, 0}, {3, 1}, {1, 3}};
  Scene scene;
  scene.target.width = scene.target.height = kSize;
  scene.viewport = {0, 0, kSize, kSize};
  Draw draw;
  draw.primitive = primitive;
  draw.provoking_vertex = which;
  for (std::size_t i = 0; i < static_cast<std::size_t>(vertices_of(kind_of(primitive))); ++i) {
    Vertex vertex;
    vertex.position = {Fixed::centre_of(kCorners[i][0]), Fixed::centre_of(kCorners[i][1])};
    vertex.color = {0, 0, 0, 1};
    vertex.color[i] = 1;
    draw.vertices.push_back(vertex);
  }
  scene.draws = {draw};
  return scene;
}

bool obeys(const Rendering& rendering, const Scene& scene) {
  const Draw& draw = scene.draws.front();
  const Color& color = draw.provoking_vertex == ProvokingVertex::first ? draw.vertices.front().color
                                                                       : draw.vertices.back().color;
  return !rendering.fragments.empty() &&
         std::all_of(
             rendering.fragments.begin(), rendering.fragments.end(), [&](const Fragment& fragment) {
               return std::equal(color.begin(), color.end(), fragment.color.begin(),
                                 [](float a, double b) { return static_cast<double>(a) == b; });
             });
}

void SceneRenderer::probe_provoking_vertices() {
  std::string names;
  for (ProvokingVertex which : {ProvokingVertex::first, ProvokingVertex::last}) {
    bool& works = limits_.provoking[static_cast<std::size_t>(which)];
    for (Primitive primitive : {Primitive::lines, Primitive::triangles}) {
      const Scene scene = provoking_scene(primitive, which);
      const Outcome outcome = render(scene);
      // Primitives that cannot be drawn at all are refused with every scene.
      const auto* rendering = std::get_if<Rendering>(&outcome);
      if (rendering != nullptr && !obeys(*rendering, scene)) works = false;
    }
    if (works) names += (names.empty() ? "" : " ") + std::string(name_of(which));
  }
  info_.traits["provoking_vertices"] = names.empty() ? "none" : names;
}

}  // namespace edgecase
