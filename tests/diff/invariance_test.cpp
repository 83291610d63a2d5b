// SPDX-License-Identifier: MIT
//
// Images of scenes: exact draws each like the scene, and what differs from it is found where it is.
#include "diff/invariance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

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

// The fragments of the scene that lie in the part that is compared.
std::vector<Fragment> first_fragments_within(const SceneImage& image) {
  std::vector<Fragment> some = drawn(*image.first).fragments;
  std::erase_if(some, [&](const Fragment& f) { return !image.part->contains({f.x, f.y}); });
  return some;
}

TEST(Invariance, ExactDrawsImagesAlike) {
  std::size_t moved = 0;
  std::size_t cut = 0;
  RandomScenes scenes(1);
  for (int i = 0; i < 300; ++i) {
    const Scene scene = scenes.next({.size = 12, .max_draws = 1, .smooth = i % 2 == 0});
    const Rendering own = drawn(scene);
    for (const SceneImage& image : images_of(scene)) {
      moved += image.right > 0 ? 1 : 0;
      cut += image.part && !first_fragments_within(image).empty() ? 1u : 0u;
      const Rendering first = image.first ? drawn(*image.first) : own;
      const auto found = variances_of(image, first, drawn(image.second));
      EXPECT_TRUE(found.empty()) << i << ": " << found.front().what;
    }
  }
  EXPECT_GT(moved, 10u);
  EXPECT_GT(cut, 100u);
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

// The triangle, and the same further right and up, in one draw.
Scene triangle_and_its_image(int right, int up) {
  Scene scene = triangle();
  scene.target.width = scene.viewport.width = 64;
  scene.target.height = scene.viewport.height = 32;
  std::vector<Vertex>& vertices = scene.draws[0].vertices;
  for (int v = 0; v < 3; ++v) {
    Vertex moved = vertices[static_cast<std::size_t>(v)];
    moved.position.x = moved.position.x + Fixed::from_integer(right);
    moved.position.y = moved.position.y + Fixed::from_integer(up);
    vertices.push_back(moved);
  }
  return scene;
}

TEST(Invariance, APrimitiveIsTheImageOfAnother) {
  const Scene scene = triangle_and_its_image(40, 13);
  Rendering own = drawn(scene);
  const auto found_in = [&](const Scene& of, const Rendering& rendering) {
    std::vector<Variance> found;
    find_variances_of_primitives(of, rendering, found);
    return found;
  };
  EXPECT_TRUE(found_in(scene, own).empty());
  const auto lost = std::ranges::find(own.fragments, 1, &Fragment::primitive);
  const PixelPosition place{lost->x - 40, lost->y - 13};
  own.fragments.erase(lost);
  const auto found = found_in(scene, own);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].pixel, place);
  EXPECT_EQ(found[0].primitive, 0);
  EXPECT_EQ(found[0].what,
            "a fragment of primitive 0 is not in its image; the image is primitive 1, which is "
            "moved by 40 pixels to the right and 13 up");
  const Result result = compare(scene, Policy{}, drawn(scene), own, {});
  EXPECT_TRUE(std::ranges::any_of(result.disagreements, [](const Disagreement& d) {
    return d.ruling == 67 && d.legality == Legality::illegal;
  }));
  Scene other = scene;  // another shape
  other.draws[0].vertices[4].position.x =
      other.draws[0].vertices[4].position.x + Fixed::from_raw(1);
  EXPECT_TRUE(found_in(other, own).empty());
  Scene cut = scene;
  cut.draws[0].scissor = Viewport{0, 0, 64, 32};
  EXPECT_TRUE(found_in(cut, own).empty());
  Scene odd = scene;  // float32 does not hold what vertices of such a target are mapped from
  odd.target.width = odd.viewport.width = 65;
  EXPECT_TRUE(found_in(odd, own).empty());
}

TEST(Invariance, ExactDrawsMovedPrimitivesAlike) {
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    Scene scene = triangle_and_its_image(static_cast<int>(random() % 48), 5);
    for (int v = 0; v < 3; ++v) {
      const auto move = [&] { return Fixed::from_raw(random() % (1 << 15)); };
      const Point by{move(), move()};
      for (const int of : {v, v + 3}) {
        Point& p = scene.draws[0].vertices[static_cast<std::size_t>(of)].position;
        p = {p.x + by.x, p.y + by.y};
      }
    }
    std::vector<Variance> found;
    find_variances_of_primitives(scene, drawn(scene), found);
    EXPECT_TRUE(found.empty()) << found.front().what;
  }
}

// Each plane that a renderer may report is asked for.
TEST(Invariance, WhatIsNotTheSameTwiceIsFoundInEachPlane) {
  const auto images = images_of(triangle());
  const SceneImage& image = image_with(images, "once more");
  Rendering first = drawn(triangle());
  const std::size_t area = first.pixels.size() / 4;
  first.samples = 2;
  first.sample_pixels.assign(2 * 4 * area, 7);
  first.accumulated.assign(4 * area, 0.5);
  first.depths.assign(2 * area, 0.25);
  first.stencils.assign(2 * area, 3);
  first.hits.assign(2 * area, 1);
  first.passes = {first};
  const auto expect_found = [&](const auto& spoil, const std::string& what) {
    for (const bool is_pass : {false, true}) {
      Rendering second = first;
      spoil(is_pass ? second.passes[0] : second);
      const auto found = variances_of(image, first, second);
      ASSERT_EQ(found.size(), 1u) << what;
      EXPECT_EQ(found[0].pixel, (PixelPosition{2, 1})) << what;
      EXPECT_EQ(found[0].ruling, 67);
      EXPECT_TRUE(found[0].what.starts_with(what)) << found[0].what;
    }
  };
  const std::size_t pixel = 10;  // (2, 1)
  expect_found([&](Rendering& r) { r.pixels[4 * pixel + 1] ^= 1; }, "the pixel has two colours");
  expect_found([&](Rendering& r) { r.sample_pixels[4 * (area + pixel)] ^= 1; },
               "sample 1 of the pixel has two colours");
  expect_found([&](Rendering& r) { r.accumulated[4 * pixel + 3] = 0.5 + 1e-16; },
               "the pixel has two sums");
  expect_found([&](Rendering& r) { r.depths[area + pixel] = 0.26; },
               "sample 1 of the pixel has two depths");
  expect_found([&](Rendering& r) { r.stencils[pixel] ^= 1; }, "sample 0 of the pixel has two sten");
  expect_found([&](Rendering& r) { ++r.hits[pixel]; }, "sample 0 of the pixel has two numbers");
}

// What the scissor test leaves is as without it; beyond its box nothing is asked.
TEST(Invariance, AScissorBoxDecidesNothingInsideIt) {
  const auto images = images_of(triangle());
  const SceneImage& image = image_with(images, "scissor");
  ASSERT_TRUE(image.first && image.part);
  const Rendering first = drawn(*image.first);
  const Rendering second = drawn(image.second);
  ASSERT_LT(second.fragments.size(), first.fragments.size());
  ASSERT_GT(second.fragments.size(), 3u);
  EXPECT_TRUE(variances_of(image, first, second).empty());
  for (std::size_t i = 0; i < first.fragments.size(); ++i) {
    Rendering spoilt = first;
    spoilt.fragments[i].color[0] += 1e-9;
    const Fragment& f = first.fragments[i];
    EXPECT_EQ(variances_of(image, spoilt, second).size(),
              image.part->contains({f.x, f.y}) ? 1u : 0u);
  }
  Rendering lost = second;
  lost.fragments.pop_back();
  EXPECT_EQ(variances_of(image, first, lost).size(), 1u);
}

TEST(Invariance, WhatTheBuffersHoldDecidesNothing) {
  const auto images = images_of(triangle());
  const SceneImage& image = image_with(images, "follows");
  EXPECT_EQ(image.behind, 1);
  const Rendering first = drawn(triangle());
  Rendering second = drawn(image.second);
  ASSERT_EQ(second.fragments.size(), 2 * first.fragments.size());
  EXPECT_TRUE(variances_of(image, first, second).empty());
  const auto of_second = std::ranges::find(second.fragments, 1, &Fragment::primitive);
  second.fragments.erase(of_second);
  const auto found = variances_of(image, first, second);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].primitive, 0);
}

// A.3 suggests it only.
TEST(Invariance, ParametersOfBlendingAreContested) {
  const Scene scene = triangle();
  const auto images = images_of(scene);
  const SceneImage& image = image_with(images, "blending");
  EXPECT_EQ(image.second.target.depth, DepthFormat::depth24);
  const Rendering first = drawn(*image.first);
  Rendering second = drawn(image.second);
  EXPECT_TRUE(variances_of(image, first, second).empty());
  second.fragments.pop_back();
  Rendering own = drawn(scene);
  own.variances = variances_of(image, first, second);
  const Result result = compare(scene, Policy{}, drawn(scene), own, {});
  ASSERT_EQ(result.disagreements.size(), 1u);
  EXPECT_EQ(result.disagreements[0].ruling, 70);
  EXPECT_EQ(result.disagreements[0].legality, Legality::contested);
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
