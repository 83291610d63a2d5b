// SPDX-License-Identifier: MIT
#include "model/scene.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace edgecase {
namespace {

// Coordinates in quarters of a pixel.
Draw draw_at(Primitive primitive, const std::vector<std::array<int, 2>>& quarters) {
  Draw draw;
  draw.primitive = primitive;
  for (const auto& [x, y] : quarters) {
    Vertex vertex;
    vertex.position = {Fixed::from_raw(x * Fixed::kOne / 4), Fixed::from_raw(y * Fixed::kOne / 4)};
    draw.vertices.push_back(vertex);
  }
  return draw;
}

Scene scene_of(std::vector<Draw> draws) {
  Scene scene;
  scene.target.width = 4;
  scene.target.height = 3;
  scene.viewport = {0, 0, 4, 4};
  scene.draws = std::move(draws);
  return scene;
}

TEST(SceneWords, TellsALine) {
  Scene scene = scene_of({draw_at(Primitive::lines, {{2, 2}, {14, 2}})});
  EXPECT_EQ(scene_text(scene), "line (1/2, 1/2) to (7/2, 1/2), 4x3");
  scene.target.surface = Surface::window;
  scene.draws[0].line_width = Fixed::from_raw(3 * Fixed::kOne / 2);
  scene.draws[0].provoking_vertex = ProvokingVertex::first;
  EXPECT_EQ(scene_text(scene),
            "line (1/2, 1/2) to (7/2, 1/2), width 3/2, first vertex provokes, 4x3, window");
}

TEST(SceneWords, TellsSeveralDraws) {
  Draw point = draw_at(Primitive::points, {{-1, 4}});
  point.point_size = Fixed::from_integer(2);
  Draw triangle = draw_at(Primitive::triangles, {{0, 0}, {4, 0}, {0, 4}});
  triangle.interpolation = Interpolation::smooth;
  triangle.scissor = Viewport{1, 0, 2, 3};
  EXPECT_EQ(scene_text(scene_of({point, triangle})),
            "point (-1/4, 1), size 2; triangle (0, 0), (1, 0), (0, 1), smooth, scissor 2x3 at (1, "
            "0), 4x3");
}

TEST(SceneWords, AbridgesWhatIsLong) {
  const std::vector<std::array<int, 2>> four(4, {4, 8});
  EXPECT_EQ(scene_text(scene_of({draw_at(Primitive::points, four)})),
            "4 points, the first point (1, 2), 4x3");
  EXPECT_EQ(scene_text(scene_of({draw_at(Primitive::lines, four)})),
            "line (1, 2) to (1, 2) and line (1, 2) to (1, 2), 4x3");
  const std::vector<std::array<int, 2>> eight(8, {4, 8});
  EXPECT_EQ(scene_text(scene_of({draw_at(Primitive::triangle_fan, eight)})),
            "triangle fan (1, 2), (1, 2), (1, 2), (1, 2), (1, 2), (1, 2) and 2 more, 4x3");
}

// Each part of a scene changed alone makes it another one.
TEST(SameScene, LooksAtEveryPart) {
  Scene scene = scene_of({draw_at(Primitive::lines, {{2, 2}, {14, 2}})});
  const std::vector<std::function<void(Scene&)>> changes{
      [](Scene& s) { ++s.target.width; },
      [](Scene& s) { ++s.target.height; },
      [](Scene& s) { ++s.target.samples; },
      [](Scene& s) { s.target.surface = Surface::window; },
      [](Scene& s) { s.target.clear[2] = 0.5F; },
      [](Scene& s) { ++s.viewport.x; },
      [](Scene& s) { ++s.viewport.y; },
      [](Scene& s) { ++s.viewport.width; },
      [](Scene& s) { ++s.viewport.height; },
      [](Scene& s) { s.draws.push_back(s.draws[0]); },
      [](Scene& s) { s.draws[0].primitive = Primitive::line_strip; },
      [](Scene& s) { s.draws[0].interpolation = Interpolation::smooth; },
      [](Scene& s) { s.draws[0].provoking_vertex = ProvokingVertex::first; },
      [](Scene& s) { s.draws[0].line_width = Fixed::from_integer(2); },
      [](Scene& s) { s.draws[0].point_size = Fixed::from_integer(2); },
      [](Scene& s) { s.draws[0].scissor = s.viewport; },
      [](Scene& s) { s.draws[0].vertices.pop_back(); },
      [](Scene& s) { s.draws[0].vertices[1].position.y = Fixed::from_raw(1); },
      [](Scene& s) { s.draws[0].vertices[0].z = Fixed::from_raw(1); },
      [](Scene& s) { s.draws[0].vertices[0].color[3] = 0; },
  };
  EXPECT_TRUE(same_scene(scene, scene));
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Scene other = scene;
    changes[i](other);
    EXPECT_FALSE(same_scene(scene, other)) << i;
    EXPECT_FALSE(same_scene(other, scene)) << i;
  }
  scene.draws[0].scissor = scene.viewport;
  Scene other = scene;
  EXPECT_TRUE(same_scene(scene, other));
  ++other.draws[0].scissor->x;
  EXPECT_FALSE(same_scene(scene, other));
}

}  // namespace
}  // namespace edgecase
