// SPDX-License-Identifier: MIT
//
// Images of scenes: exact draws each like the scene, and what differs from it is found where it is.
#include "diff/invariance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "diff/compare.h"
#include "raster/rasterizer.h"
#include "rules/choices.h"
#include "tests/raster/random_scenes.h"

namespace edgecase {
namespace {

// A triangle in the middle of a target.
Scene triangle() {
  Scene scene = blank_scene(8, 8);
  const auto at = [](int x, int y) {
    return Point{Fixed::from_integer(x), Fixed::from_integer(y)};
  };
  scene.draws.push_back(make_draw(Primitive::triangles, std::array{at(1, 1), at(7, 2), at(3, 7)}));
  return scene;
}

std::vector<Variance> variances_of(const SceneImage& image, const Rendering& first,
                                   const Rendering& second) {
  std::vector<Variance> found;
  find_variances(image, first, second, found);
  return found;
}

Rendering drawn(const Scene& scene) {
  return rasterize(scene, Policy{});
}

const SceneImage& image_with(const std::vector<SceneImage>& images, std::string_view word) {
  return *std::ranges::find_if(
      images, [&](const SceneImage& image) { return image.text.find(word) != std::string::npos; });
}

TEST(Invariance, ExactDrawsImagesAlike) {
  std::size_t moved = 0;
  RandomScenes scenes(1);
  for (int i = 0; i < 300; ++i) {
    const Scene scene = scenes.next({.size = 12, .max_draws = 1, .smooth = i % 2 == 0});
    const Rendering own = drawn(scene);
    for (const SceneImage& image : images_of(scene)) {
      moved += image.right > 0 ? 1 : 0;
      const Rendering first = image.first ? drawn(*image.first) : own;
      const auto found = variances_of(image, first, drawn(image.second));
      EXPECT_TRUE(found.empty()) << i << ": " << found.front().what;
    }
  }
  EXPECT_GT(moved, 10u);
}

TEST(Invariance, AFragmentThatIsLostOnTheWayIsFound) {
  const auto images = images_of(triangle());
  const SceneImage& image = image_with(images, "moved");
  ASSERT_TRUE(image.first);
  const Rendering first = drawn(*image.first);
  Rendering second = drawn(image.second);
  ASSERT_EQ(first.fragments.size(), second.fragments.size());
  const Fragment lost = second.fragments[3];
  second.fragments.erase(second.fragments.begin() + 3);
  auto found = variances_of(image, first, second);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].pixel, (PixelPosition{lost.x - image.right, lost.y - image.up}));
  EXPECT_EQ(found[0].primitive, 0);
  found = variances_of(image, second, first);  // each where the other is not
  EXPECT_FALSE(found.empty());
}

// The targets of what is moved are larger than that of the scene.
TEST(Invariance, WhatIsDrawnBeyondTheTargetIsToldAtItsBorder) {
  const Scene scene = triangle();
  const auto images = images_of(scene);
  const SceneImage& image = image_with(images, "moved");
  const Rendering first = drawn(*image.first);
  Rendering second = drawn(image.second);
  Fragment far = second.fragments.back();
  far.x = image.right - 2;
  far.y = image.up + 40;
  second.fragments.push_back(far);
  Rendering own = drawn(scene);
  own.variances = variances_of(image, first, second);
  const Result result = compare(scene, Policy{}, drawn(scene), own, {});
  ASSERT_EQ(result.disagreements.size(), 1u);
  EXPECT_EQ(result.disagreements[0].x, 0);
  EXPECT_EQ(result.disagreements[0].y, 7);
  EXPECT_NE(result.disagreements[0].explanation.find("at (-2, 40), beyond the target"),
            std::string::npos)
      << result.disagreements[0].explanation;
}

TEST(Invariance, AValueThatDependsOnTheMaskIsFound) {
  const Scene scene = triangle();
  const auto images = images_of(scene);
  const SceneImage& image = image_with(images, "masked");
  EXPECT_FALSE(image.second.draws[0].operations.color_mask[0]);
  const Rendering first = drawn(scene);
  Rendering second = first;
  EXPECT_TRUE(variances_of(image, first, second).empty());
  second.pixels[0] ^= 1;  // the picture may differ
  EXPECT_TRUE(variances_of(image, first, second).empty());
  second.fragments[2].color[1] += 1e-9;
  EXPECT_EQ(variances_of(image, first, second).size(), 1u);
  second.fragments[2].has_color = false;  // what is not told is not asked
  EXPECT_TRUE(variances_of(image, first, second).empty());
  second.fragments[2].depth += 1e-9;
  EXPECT_EQ(variances_of(image, first, second).size(), 1u);
}

TEST(Invariance, APictureThatIsNotTheSameTwiceIsFound) {
  const Scene scene = triangle();
  const auto images = images_of(scene);
  const SceneImage& image = image_with(images, "once more");
  const Rendering first = drawn(scene);
  Rendering second = first;
  second.pixels[4 * 10 + 1] ^= 1;
  const auto found = variances_of(image, first, second);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].pixel, (PixelPosition{2, 1}));
}

// A gross difference is not listed to its end.
TEST(Invariance, TheFirstAreListed) {
  const Scene scene = triangle();
  const auto images = images_of(scene);
  const SceneImage& image = image_with(images, "once more");
  const Rendering first = drawn(scene);
  Rendering second = first;
  for (std::uint8_t& code : second.pixels) code ^= 1;
  EXPECT_EQ(variances_of(image, first, second).size(), 64u);
}

TEST(Invariance, WhatIsCutIsNotMoved) {
  const auto moves = [](const Scene& scene) {
    return std::ranges::any_of(images_of(scene),
                               [](const SceneImage& image) { return image.right > 0; });
  };
  EXPECT_TRUE(moves(triangle()));
  Scene beyond = triangle();
  beyond.draws[0].vertices[1].position.x = Fixed::from_integer(9);
  EXPECT_FALSE(moves(beyond));
  Scene sampled = triangle();
  sampled.target.samples = 4;
  EXPECT_FALSE(moves(sampled));
  Scene part = triangle();
  part.viewport.width = 4;
  EXPECT_FALSE(moves(part));
  Scene line = triangle();
  line.draws[0].primitive = Primitive::lines;
  line.draws[0].vertices.pop_back();
  EXPECT_TRUE(moves(line));
  line.draws[0].line_width = Fixed::from_integer(4);
  EXPECT_FALSE(moves(line));  // the half of its width may reach beyond
}

}  // namespace
}  // namespace edgecase
