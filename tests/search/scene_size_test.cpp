// SPDX-License-Identifier: MIT
#include "search/scene_size.h"

#include <gtest/gtest.h>

#include "tests/search/faulty_renderer.h"

namespace edgecase {
namespace {

Scene lines(int size, std::vector<Point> points) {
  return scene_with(size, {make_draw(Primitive::lines, points)});
}

TEST(SceneSize, FractionBitsOfNumbers) {
  EXPECT_EQ(fraction_bits_of(Fixed()), 0);
  EXPECT_EQ(fraction_bits_of(Fixed::from_integer(-12)), 0);
  EXPECT_EQ(fraction_bits_of(Fixed::from_raw(Fixed::kOne / 2)), 1);
  EXPECT_EQ(fraction_bits_of(Fixed::from_raw(-3 * Fixed::kOne / 16)), 4);
  EXPECT_EQ(fraction_bits_of(Fixed::from_raw(1)), 16);
  EXPECT_EQ(fraction_bits_of(Fixed::from_raw(-1)), 16);
}

TEST(SceneSize, FractionBitsOfAScene) {
  EXPECT_EQ(fraction_bits_of(lines(8, {sixteenths(16, 32), sixteenths(32, 16)})), 0);
  EXPECT_EQ(fraction_bits_of(lines(8, {sixteenths(16, 33), sixteenths(36, 16)})), 4);
  Scene deep = lines(8, {sixteenths(16, 32), sixteenths(32, 16)});
  deep.draws[0].vertices[1].z = Fixed::from_raw(Fixed::kOne / 4);
  EXPECT_EQ(fraction_bits_of(deep), 2);
}

// Each scene is simpler than the one before.
TEST(SceneSize, Orders) {
  std::vector<Scene> scenes;
  Scene scene = lines(8, {sixteenths(17, 33), sixteenths(90, 90), sixteenths(17, 33),
                          sixteenths(100, 20), sixteenths(1, 2), sixteenths(3, 4)});
  scene.target.depth = DepthFormat::depth24;
  scenes.push_back(scene);
  scene.draws[0].vertices.resize(4);
  scenes.push_back(scene);
  scene.draws[0].primitive = Primitive::line_strip;
  scene.draws[0].vertices.resize(3);
  scenes.push_back(scene);
  scene.draws[0].primitive = Primitive::lines;
  scene.draws[0].vertices.resize(4);
  scenes.push_back(scene);
  scene.target.depth = DepthFormat::none;
  scenes.push_back(scene);
  scene.draws[0].vertices.resize(2);
  scenes.push_back(scene);
  scene.draws[0].vertices[0].position = sixteenths(16, 34);
  scenes.push_back(scene);
  scene.target.height = 7;
  scenes.push_back(scene);
  scene.draws[0].vertices[0].position = sixteenths(16, 32);
  scenes.push_back(scene);
  scene.draws[0].vertices[0].position = sixteenths(16, 16);
  scenes.push_back(scene);
  // The strip of two is not simpler than the two lines, nor the other way round by primitives.
  for (std::size_t i = 1; i < scenes.size(); ++i) {
    if (i == 2) continue;
    EXPECT_LT(size_of(scenes[i]), size_of(scenes[i - 1])) << i;
  }
  EXPECT_LT(size_of(scenes[3]), size_of(scenes[2]));
}

TEST(SceneSize, FewerDrawsAreSimplerThanMore) {
  const std::vector<Point> one = {sixteenths(16, 32), sixteenths(32, 16)};
  const std::vector<Point> both = {one[0], one[1], one[0], one[1]};
  const Scene apart =
      scene_with(8, {make_draw(Primitive::lines, one), make_draw(Primitive::lines, one)});
  EXPECT_LT(size_of(lines(8, both)), size_of(apart));
}

TEST(SceneSize, EqualValuesAreSimplerThanDifferentOnes) {
  EXPECT_LT(size_of(lines(8, {sixteenths(32, 32), sixteenths(32, 64)})),
            size_of(lines(8, {sixteenths(32, 32), sixteenths(16, 64)})));
}

}  // namespace
}  // namespace edgecase
