// SPDX-License-Identifier: MIT
#include "model/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "model/case.h"

namespace edgecase {
namespace {

Draw draw_of(Primitive primitive, std::size_t vertices) {
  Draw draw;
  draw.primitive = primitive;
  draw.vertices.resize(vertices);
  return draw;
}

TEST(PrimitivesOf, NumbersInDrawingOrderOverAllDraws) {
  Scene scene;
  scene.draws = {draw_of(Primitive::lines, 4), draw_of(Primitive::triangles, 3),
                 draw_of(Primitive::points, 0), draw_of(Primitive::points, 3)};
  const auto primitives = primitives_of(scene);
  const int draws[] = {0, 0, 1, 3, 3, 3};
  const std::size_t first_vertices[] = {0, 2, 0, 0, 1, 2};
  ASSERT_EQ(primitives.size(), std::size(draws));
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    EXPECT_EQ(primitives[i].index, static_cast<int>(i));
    EXPECT_EQ(primitives[i].draw, draws[i]);
    const Draw& draw = scene.draws[static_cast<std::size_t>(draws[i])];
    EXPECT_EQ(primitives[i].state, &draw);
    EXPECT_EQ(primitives[i].vertices[0], draw.vertices.data() + first_vertices[i]);
  }
}

TEST(PrimitivesOf, LeavesOutAnIncompletePrimitive) {
  Scene scene;
  scene.draws = {draw_of(Primitive::triangles, 5), draw_of(Primitive::lines, 1)};
  EXPECT_EQ(primitives_of(scene).size(), 1u);
  EXPECT_TRUE(primitives_of(Scene{}).empty());
}

// GL 4.6 core, 10.1 and table 13.2, for five vertices; a turned triangle of a strip begins with its
// second vertex.
struct Assembly {
  Primitive primitive;
  std::vector<std::vector<int>> vertices;  // places in the draw
  std::vector<int> first;                  // which of the draw's vertices provokes
  std::vector<int> last;
};

TEST(PrimitivesOf, AssemblesStripsLoopsAndFans) {
  const Assembly assemblies[] = {
      {Primitive::line_strip, {{0, 1}, {1, 2}, {2, 3}, {3, 4}}, {0, 1, 2, 3}, {1, 2, 3, 4}},
      {Primitive::line_loop,
       {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}},
       {0, 1, 2, 3, 4},
       {1, 2, 3, 4, 0}},
      {Primitive::triangle_strip, {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}, {0, 1, 2}, {2, 3, 4}},
      {Primitive::triangle_fan, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}, {1, 2, 3}, {2, 3, 4}},
  };
  for (const Assembly& expected : assemblies) {
    Scene scene;
    scene.draws = {draw_of(expected.primitive, 5)};
    const Vertex* base = scene.draws[0].vertices.data();
    const auto primitives = primitives_of(scene);
    ASSERT_EQ(primitives.size(), expected.vertices.size()) << name_of(expected.primitive);
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const auto& vertices = primitives[i].vertices;
      ASSERT_EQ(static_cast<std::size_t>(vertices_of(primitives[i].kind)),
                expected.vertices[i].size());
      for (std::size_t v = 0; v < expected.vertices[i].size(); ++v)
        EXPECT_EQ(vertices[v] - base, expected.vertices[i][v]) << name_of(expected.primitive) << i;
      EXPECT_EQ(vertices[static_cast<std::size_t>(primitives[i].provoking_first)] - base,
                expected.first[i]);
      EXPECT_EQ(vertices[static_cast<std::size_t>(primitives[i].provoking_last)] - base,
                expected.last[i]);
    }
  }
}

TEST(VertexCount, IsWholePrimitivesAndAtLeastOne) {
  const std::pair<Primitive, std::vector<int>> accepted[] = {
      {Primitive::points, {1, 2, 3, 4, 5, 6, 7}},
      {Primitive::lines, {2, 4, 6}},
      {Primitive::line_strip, {2, 3, 4, 5, 6, 7}},
      {Primitive::line_loop, {2, 3, 4, 5, 6, 7}},
      {Primitive::triangles, {3, 6}},
      {Primitive::triangle_strip, {3, 4, 5, 6, 7}},
      {Primitive::triangle_fan, {3, 4, 5, 6, 7}}};
  for (const auto& [primitive, counts] : accepted)
    for (int count = 0; count <= 7; ++count)
      EXPECT_EQ(is_vertex_count(primitive, static_cast<std::size_t>(count)),
                std::find(counts.begin(), counts.end(), count) != counts.end())
          << name_of(primitive) << " " << count;
}

TEST(Diagnostic, SaysWhatItKnows) {
  EXPECT_EQ(to_string(Diagnostic{"a.json", 0, "", "it is gone", ""}), "a.json: it is gone");
  EXPECT_EQ(to_string(Diagnostic{"a.json", 7, "/target/width", "too wide", "use 4096 or less"}),
            "a.json:7: /target/width: too wide; use 4096 or less");
}

}  // namespace
}  // namespace edgecase
