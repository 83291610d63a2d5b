// SPDX-License-Identifier: MIT
//
// Scenes drawn by hand, top row first: '.' no fragment, '#' one, '2' two.
#include <gtest/gtest.h>

#include <string>

#include "raster/rasterizer.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

std::string hits(const Rendering& rendering) {
  std::string rows;
  for (int y = rendering.height - 1; y >= 0; --y) {
    for (int x = 0; x < rendering.width; ++x) {
      const std::uint32_t count = rendering.hits[rendering.pixel_index(x, y)];
      rows += count == 0 ? '.' : count == 1 ? '#' : static_cast<char>('0' + count);
    }
    rows += '/';
  }
  return rows;
}

std::array<int, 4> pixel(const Rendering& rendering, int x, int y) {
  const std::uint8_t* p = rendering.pixels.data() + 4 * rendering.pixel_index(x, y);
  return {p[0], p[1], p[2], p[3]};
}

Scene scene_of(int size, Primitive primitive, std::vector<Point> positions) {
  Scene scene = blank_scene(size, size);
  scene.draws = {make_draw(primitive, positions)};
  return scene;
}

TEST(Rasterize, PointsCoverThePixelTheyLieIn) {
  const Scene scene =
      scene_of(4, Primitive::points, {at(0.25, 0.75), at(2.5, 1.5), at(3, 3), at(9, 9)});
  EXPECT_EQ(hits(rasterize(scene, {})), "...#/..../..#./#.../");
}

TEST(Rasterize, ALineEndsBeforeItsLastDiamond) {
  EXPECT_EQ(hits(rasterize(scene_of(4, Primitive::lines, {at(0.5, 1.5), at(3.5, 1.5)}), {})),
            "..../..../###./..../");
  EXPECT_EQ(hits(rasterize(scene_of(4, Primitive::lines, {at(3.5, 1.5), at(0.5, 1.5)}), {})),
            "..../..../.###/..../");
}

TEST(Rasterize, ALineThroughTheTargetIsCutAtItsBorder) {
  EXPECT_EQ(hits(rasterize(scene_of(4, Primitive::lines, {at(-3.5, -3.5), at(9.5, 9.5)}), {})),
            "...#/..#./.#../#.../");
}

TEST(Rasterize, ATriangleOwnsItsLeftThenItsTopEdges) {
  const std::vector<Point> lower_left = {at(0.5, 0.5), at(3.5, 0.5), at(0.5, 3.5)};
  EXPECT_EQ(hits(rasterize(scene_of(4, Primitive::triangles, lower_left), {})),
            "..../#.../##../..../");
  const std::vector<Point> upper_right = {at(3.5, 3.5), at(3.5, 0.5), at(0.5, 3.5)};
  EXPECT_EQ(hits(rasterize(scene_of(4, Primitive::triangles, upper_right), {})),
            "###./.##./..#./..../");
}

TEST(Rasterize, APolicyChoosesTiesAndSnapPerPrimitive) {
  const Scene scene = scene_of(4, Primitive::triangles, {at(0.5, 0.5), at(3.5, 0.5), at(0.5, 3.5)});
  Policy policy;
  policy.rules = {{"triangle.fill-rule", "left-bottom"}, {"line.diamond-exit", "right-top"}};
  EXPECT_EQ(hits(rasterize(scene, policy)), "..../#.../##../###./");
  Scene near = scene;
  near.draws[0].vertices[0].position.x = near.draws[0].vertices[2].position.x =
      at(0.5 + 1.0 / 1024, 0).x;
  EXPECT_EQ(hits(rasterize(near, policy)), "..../.#../.##./.##./");
  policy.rules["triangle.snap"] = "8-half-even";
  EXPECT_EQ(hits(rasterize(near, policy)), "..../#.../##../###./");
}

TEST(Rasterize, OverdrawIsCountedAndTheLastFragmentStays) {
  Scene scene = blank_scene(3, 3);
  scene.target.clear = color_of_bytes(1, 2, 3);
  const std::vector<Point> whole = {at(0, 0), at(6, 0), at(0, 6)};
  const std::vector<Point> row = {at(0.5, 1.5), at(2.5, 1.5)};
  scene.draws = {make_draw(Primitive::lines, row), make_draw(Primitive::triangles, whole, 1),
                 make_draw(Primitive::lines, row, 2)};
  scene.draws[0].vertices[1].color = color_of_bytes(255, 0, 0);
  scene.draws[1].vertices[2].color = color_of_bytes(0, 255, 0);
  scene.draws[2].vertices[1].color = color_of_bytes(0, 0, 255);
  const Rendering rendering = rasterize(scene, {});
  EXPECT_EQ(hits(rendering), "###/33#/###/");
  EXPECT_EQ(pixel(rendering, 0, 0), (std::array{0, 255, 0, 255}));
  EXPECT_EQ(pixel(rendering, 1, 1), (std::array{0, 0, 255, 255}));
  ASSERT_EQ(rendering.fragments.size(), 13u);
  EXPECT_EQ(rendering.fragments[3].primitive, 0);
  EXPECT_EQ(rendering.fragments[4].primitive, 1);
  EXPECT_EQ(rendering.fragments[5].primitive, 2);
}

TEST(Rasterize, UntouchedPixelsHoldTheClearColour) {
  Scene scene = blank_scene(2, 1);
  scene.target.clear = {0.5f, 0, 1, 0};
  const Rendering rendering = rasterize(scene, {});
  EXPECT_EQ(pixel(rendering, 0, 0), (std::array{128, 0, 255, 0}));
  EXPECT_EQ(pixel(rendering, 1, 0), (std::array{128, 0, 255, 0}));
  EXPECT_TRUE(rendering.fragments.empty());
  EXPECT_EQ(rendering.hits, std::vector<std::uint32_t>(2));
}

}  // namespace
}  // namespace edgecase
