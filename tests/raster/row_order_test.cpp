// SPDX-License-Identifier: MIT
//
// line.row-order: a target seen upside down. Turning the target over turns every tie over, so the
// diamond-exit rule with rows from the top must draw what it draws with the other vertical tie.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "raster/rasterizer.h"

namespace edgecase {
namespace {

Scene line_scene(Point a, Point b) {
  Scene scene;
  scene.target.width = 4;
  scene.target.height = 3;
  scene.viewport = {0, 0, 4, 4};
  Draw draw;
  draw.primitive = Primitive::lines;
  draw.vertices = {{a, {}, {}}, {b, {}, {}}};
  scene.draws = {draw};
  return scene;
}

std::vector<std::pair<int, int>> drawn(const Scene& scene, const Policy& policy) {
  std::vector<std::pair<int, int>> pixels;
  for (const Fragment& f : rasterize(scene, policy).fragments) pixels.emplace_back(f.x, f.y);
  return pixels;
}

Policy policy_with(Choices rules) {
  Policy policy;
  policy.rules = std::move(rules);
  return policy;
}

Point quarters(int x, int y) {
  return {Fixed::from_raw(x * Fixed::kOne / 4), Fixed::from_raw(y * Fixed::kOne / 4)};
}

TEST(RowOrder, TurnsTheVerticalTieOver) {
  const std::pair<const char*, const char*> turned[] = {{"left-bottom", "left-top"},
                                                        {"right-top", "right-bottom"},
                                                        {"top-left", "bottom-left"},
                                                        {"open", "open"},
                                                        {"closed", "closed"}};
  int scenes = 0;
  int changed = 0;
  for (const auto& [tie, other] : turned)
    for (int ay = 0; ay <= 12; ++ay)
      for (int ax = 0; ax <= 16; ax += 2)
        for (int by = 0; by <= 12; by += 2)
          for (int bx = 0; bx <= 16; bx += 2) {
            const Scene scene = line_scene(quarters(ax, ay), quarters(bx, by));
            const auto seen = drawn(
                scene, policy_with({{"line.diamond-exit", tie}, {"line.row-order", "top-down"}}));
            ASSERT_EQ(seen, drawn(scene, policy_with({{"line.diamond-exit", other}})));
            changed += seen != drawn(scene, policy_with({{"line.diamond-exit", tie}})) ? 1 : 0;
            ++scenes;
          }
  EXPECT_EQ(scenes, 5 * 13 * 9 * 7 * 9);
  EXPECT_GT(changed, 100) << "ties must be turned over, or this proves nothing";
}

// What the integer algorithms do with halves and negative numbers depends on which way is up.
TEST(RowOrder, ChangesBresenham) {
  const Scene scene = line_scene(quarters(2, 6), quarters(14, 8));
  const Policy up = policy_with({{"line.algorithm", "bresenham"}});
  const Policy down =
      policy_with({{"line.algorithm", "bresenham"}, {"line.row-order", "top-down"}});
  EXPECT_NE(drawn(scene, up), drawn(scene, down));
}

// A scene upside down, scissor included.
Scene turned_over(Scene scene) {
  const Fixed height = Fixed::from_integer(scene.target.height);
  for (Draw& draw : scene.draws) {
    for (Vertex& vertex : draw.vertices) vertex.position.y = height - vertex.position.y;
    if (draw.scissor)
      draw.scissor->y = scene.target.height - draw.scissor->y - draw.scissor->height;
  }
  return scene;
}

// Seeing the target upside down is drawing the scene upside down, and turning the picture over:
// for every kind of primitive, with rounding, offsets and a scissor box that is not in the middle.
TEST(RowOrder, IsTheSceneUpsideDown) {
  const Choices rules = {{"subpixel.snap", "4-half-up"},
                         {"triangle.algorithm", "scan"},
                         {"point.offset", "right-down"},
                         {"line.algorithm", "bresenham"}};
  Choices turned = rules;
  for (const char* rule : {"point.row-order", "line.row-order", "triangle.row-order"})
    turned[rule] = "top-down";
  int changed = 0;
  for (const Primitive primitive : {Primitive::points, Primitive::lines, Primitive::triangles})
    for (int shift = 0; shift < 64; ++shift) {
      Scene scene;
      scene.target.width = 8;
      scene.target.height = 7;
      scene.viewport = {0, 0, 8, 8};
      Draw draw;
      draw.primitive = primitive;
      draw.point_size = Fixed::from_integer(3);
      draw.scissor = Viewport{1, 1, 6, 4};
      const auto at = [&](int x, int y) {
        return Point{Fixed::from_raw(x * Fixed::kOne / 32),
                     Fixed::from_raw((y + shift) * Fixed::kOne / 32)};
      };
      const std::vector<Point> points = {at(40, 33), at(220, 61), at(97, 151)};
      const auto count = static_cast<std::size_t>(vertices_of(kind_of(primitive)));
      for (std::size_t i = 0; i < count; ++i) draw.vertices.push_back({points[i], {}, {}});
      scene.draws = {draw};
      const auto seen = drawn(scene, policy_with(turned));
      auto expected = drawn(turned_over(scene), policy_with(rules));
      for (auto& [x, y] : expected) y = scene.target.height - 1 - y;
      std::sort(expected.begin(), expected.end(), [](const auto& a, const auto& b) {
        return std::pair{a.second, a.first} < std::pair{b.second, b.first};
      });
      ASSERT_EQ(seen, expected) << name_of(primitive) << " " << shift;
      changed += seen != drawn(scene, policy_with(rules)) ? 1 : 0;
    }
  EXPECT_GT(changed, 30);
}

}  // namespace
}  // namespace edgecase
