// SPDX-License-Identifier: MIT
#include "model/scene.h"

#include <gtest/gtest.h>

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
    EXPECT_EQ(primitives[i].vertices, draw.vertices.data() + first_vertices[i]);
  }
}

TEST(PrimitivesOf, LeavesOutAnIncompletePrimitive) {
  Scene scene;
  scene.draws = {draw_of(Primitive::triangles, 5), draw_of(Primitive::lines, 1)};
  EXPECT_EQ(primitives_of(scene).size(), 1u);
  EXPECT_TRUE(primitives_of(Scene{}).empty());
}

TEST(Diagnostic, SaysWhatItKnows) {
  EXPECT_EQ(to_string(Diagnostic{"a.json", 0, "", "it is gone", ""}), "a.json: it is gone");
  EXPECT_EQ(to_string(Diagnostic{"a.json", 7, "/target/width", "too wide", "use 4096 or less"}),
            "a.json:7: /target/width: too wide; use 4096 or less");
}

}  // namespace
}  // namespace edgecase
