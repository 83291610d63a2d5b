// SPDX-License-Identifier: MIT
//
// What is said of clipped triangles, and the polygons that are left of them, by hand.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "rules/coverage/clip_polygon.h"
#include "rules/coverage/clip_volume.h"
#include "rules/values/clipped_attributes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;

// Of 8x8 pixels; w is 1, x and y are given in pixels.
struct Corner {
  float x, y;
  float z = 0;
};

Scene scene_of(const std::array<Corner, 3>& corners) {
  Scene scene;
  scene.target.width = scene.target.height = 8;
  scene.viewport = {0, 0, 8, 8};
  Draw& draw = scene.draws.emplace_back();
  for (const Corner& corner : corners) {
    Vertex vertex;
    vertex.clip = ClipPosition{corner.x / 4 - 1, corner.y / 4 - 1, corner.z, 1};
    draw.vertices.push_back(vertex);
  }
  return scene;
}

std::string words_at(const std::array<Corner, 3>& corners, double x, double y) {
  const Scene scene = scene_of(corners);
  const ScenePrimitive triangle = primitives_of(scene).at(0);
  return explain_clipped_triangle(triangle, at(x, y), *find_tie_rule("left-bottom")).text;
}

TEST(ClipWords, NameTheEdgeThatDecides) {
  const std::array<Corner, 3> corners{{{1, 1}, {13, 1}, {1, 13}}};
  EXPECT_THAT(words_at(corners, 2.5, 2.5), HasSubstr("lies inside all three edges, where"));
  EXPECT_THAT(words_at(corners, 7.5, 7.5),
              HasSubstr("lies outside the edge of the second and the third vertex and is not"));
  EXPECT_THAT(words_at(corners, 0.5, 4.5),
              HasSubstr("lies outside the edge of the third and the first vertex and is not"));
  EXPECT_THAT(words_at(corners, 4.5, 0.5),
              HasSubstr("lies outside the edge of the first and the second vertex and is not"));
  EXPECT_THAT(words_at(corners, 7, 7),
              HasSubstr("lies on the edge of the second and the third vertex and is not"));
  EXPECT_THAT(words_at(corners, 1, 4.5),
              HasSubstr("lies on the edge of the third and the first vertex, where"));
  EXPECT_THAT(words_at(corners, 4.5, 1),
              HasSubstr("lies on the edge of the first and the second vertex, where"));
  // Turned over, the same edges decide.
  const std::array<Corner, 3> turned{{{1, 1}, {1, 13}, {13, 1}}};
  EXPECT_THAT(words_at(turned, 2.5, 2.5), HasSubstr("lies inside all three edges, where"));
  EXPECT_THAT(words_at(turned, 0.5, 4.5),
              HasSubstr("lies outside the edge of the first and the second vertex and is not"));
}

TEST(ClipWords, NameTheVerticesOutside) {
  const std::string words = words_at({{{0, 0}, {12, 0}, {0, 12}}}, 2.5, 2.5);
  EXPECT_THAT(words, HasSubstr("(the second vertex at (2, -1, 0, 1), the third vertex at "
                               "(-1, 2, 0, 1)), and what is seen of it is the polygon"));
}

TEST(ClipWords, TellWhatHidesTheSample) {
  const std::array<Corner, 3> deep{{{1, 1, 0}, {13, 1, 3}, {1, 13, 0}}};
  EXPECT_THAT(words_at(deep, 6.5, 2.5), HasSubstr("nearer than near or farther than far"));
  EXPECT_THAT(words_at({{{1, 1}, {13, 1}, {1, 13}}}, 8.5, 2.5), HasSubstr("beyond the viewport"));
  EXPECT_THAT(words_at({{{1, 1}, {5, 5}, {9, 9}}}, 2.5, 2.5), HasSubstr("the triangle has none"));
  EXPECT_THAT(words_at({{{9, 9}, {13, 9}, {9, 13}}}, 2.5, 2.5), HasSubstr("nothing of it is seen"));
}

// The corners in order, "!" after one that clipping has made.
std::string polygon_of(const std::array<Point, 3>& corners,
                       const ClipPlanes& planes = sides_of({0, 0, 8, 8})) {
  UnclippedTriangle triangle;
  for (std::size_t i = 0; i < 3; ++i) triangle.positions[i] = homogeneous(corners[i]);
  std::string text;
  for (const ClipPolygonVertex& vertex : clip_polygon(triangle, planes, 1)) {
    const Point p = vertex.position;
    text += fmt::format("{},{}", p.x.to_double(), p.y.to_double());
    text += vertex.made ? "! " : " ";
  }
  return text;
}

// Vertices and whole edges that lie on a plane are not beyond it.
TEST(ClipPolygon, WhatOnlyTouchesAPlaneIsLeftAsItIs) {
  EXPECT_EQ(polygon_of({at(0, 0), at(8, 0), at(0, 8)}), "0,0 8,0 0,8 ");
  EXPECT_EQ(polygon_of({at(0, 8), at(8, 0), at(0, 0)}), "0,8 8,0 0,0 ");
  EXPECT_EQ(polygon_of({at(4, 0), at(8, 4), at(4, 8)}), "4,0 8,4 4,8 ");
}

TEST(ClipPolygon, CutsEachSideWhereItIsCrossed) {
  EXPECT_EQ(polygon_of({at(-4, 0), at(4, 0), at(4, 8)}), "0,0! 4,0 4,8 0,4! ");
  EXPECT_EQ(polygon_of({at(12, 8), at(4, 8), at(4, 0)}), "8,8! 4,8 4,0 8,4! ");
  EXPECT_EQ(polygon_of({at(0, -4), at(0, 4), at(8, 4)}), "0,0! 0,4 8,4 4,0! ");
  EXPECT_EQ(polygon_of({at(8, 12), at(8, 4), at(0, 4)}), "8,8! 8,4 0,4 4,8! ");
  // One vertex on the plane, one beyond it: a single cut.
  EXPECT_EQ(polygon_of({at(0, 0), at(-4, 4), at(4, 4)}), "0,0 0,4! 4,4 ");
  EXPECT_EQ(polygon_of({at(-4, 0), at(0, 4), at(-4, 8)}), "");
}

// Sides of a volume twice as large stand half the viewport's extent beyond its own; a viewport of
// odd extent has them between pixels.
TEST(ClipPolygon, CutsAtDoubledSides) {
  const ClipPlanes even = doubled_sides_of({0, 0, 8, 8});
  EXPECT_EQ(polygon_of({at(-4, -4), at(12, -4), at(-4, 12)}, even), "-4,-4 12,-4 -4,12 ");
  EXPECT_EQ(polygon_of({at(-12, 0), at(4, 0), at(4, 8)}, even), "-4,0! 4,0 4,8 -4,4! ");
  const ClipPlanes odd = doubled_sides_of({1, 2, 5, 7});
  EXPECT_EQ(polygon_of({at(-3.5, 2), at(2.5, 2), at(0.5, 4)}, odd), "-1.5,2! 2.5,2 0.5,4 -1.5,3! ");
  EXPECT_EQ(polygon_of({at(10.5, 4), at(6.5, 4), at(6.5, 2)}, odd), "8.5,4! 6.5,4 6.5,2 8.5,3! ");
  EXPECT_EQ(polygon_of({at(2, -5.5), at(2, 2.5), at(6, 2.5)}, odd), "2,-1.5! 2,2.5 6,2.5 4,-1.5! ");
  EXPECT_EQ(polygon_of({at(6, 16.5), at(6, 8.5), at(2, 8.5)}, odd), "6,12.5! 6,8.5 2,8.5 4,12.5! ");
}

// The vertices of a triangle that is smaller than half a unit of 2^-16 meet in one point, though
// the triangle has an area.
TEST(ClippedPlane, IsNoneWhereRoundingLeavesNoArea) {
  const auto has_plane = [](float side) {
    const Scene scene = scene_of({{{4, 4}, {4 + side, 4}, {4, 4 + side}}});
    const ScenePrimitive triangle = primitives_of(scene).at(0);
    EXPECT_NE(cross(triangle.positions[0], triangle.positions[1], triangle.positions[2]), 0);
    return ClippedPlane::of(triangle).has_value();
  };
  EXPECT_TRUE(has_plane(1));
  EXPECT_FALSE(has_plane(0x1p-18F));
}

// A mark of each corner of what is seen, and its outline.
TEST(ClipWords, DrawWhatIsSeen) {
  const Scene scene = scene_of({{{0, 0}, {16, 0}, {0, 8}}});
  ScenePrimitive triangle = primitives_of(scene).at(0);
  triangle.index = 7;
  const Figure figure = figure_of_seen(triangle);
  const std::vector<std::pair<double, double>> corners{{0, 0}, {8, 0}, {8, 4}, {0, 8}};
  const bool made[] = {false, true, true, false};
  ASSERT_EQ(figure.marks.size(), corners.size() + 1);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    EXPECT_EQ(figure.marks[i].role, MarkRole::vertex);
    EXPECT_THAT(figure.marks[i].points, ::testing::ElementsAre(corners[i]));
    EXPECT_EQ(figure.marks[i].label.starts_with("made by clipping, about ("), made[i]) << i;
    EXPECT_EQ(figure.marks[i].label.starts_with("about ("), !made[i]) << i;
  }
  EXPECT_EQ(figure.marks.back().role, MarkRole::primitive);
  EXPECT_EQ(figure.marks.back().points, corners);
  EXPECT_EQ(figure.marks.back().label, "7");
  EXPECT_TRUE(figure.marks.back().closed);
  triangle.kind = PrimitiveKind::point;
  EXPECT_TRUE(figure_of_seen(triangle).marks.empty());
  const Scene unseen = scene_of({{{9, 9}, {13, 9}, {9, 13}}});
  EXPECT_TRUE(figure_of_seen(primitives_of(unseen).at(0)).marks.empty());
}

}  // namespace
}  // namespace edgecase
