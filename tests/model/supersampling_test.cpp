// SPDX-License-Identifier: MIT
#include "model/sampling.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "exact/homogeneous.h"
#include "exact/rational.h"
#include "model/scene.h"

namespace edgecase {
namespace {

using testing::IsEmpty;

Point at(std::int64_t raw_x, std::int64_t raw_y) {
  return {Fixed::from_raw(raw_x), Fixed::from_raw(raw_y)};
}

const Point kCentre = at(Fixed::kOne / 2, Fixed::kOne / 2);

Vertex clip_vertex(ClipPosition clip, const Viewport& viewport) {
  Vertex vertex;
  vertex.clip = clip;
  vertex.w = clip.w;
  vertex.position = nearest_point(window_position(clip, viewport));
  return vertex;
}

// A triangle in the window, one in clip coordinates, in a viewport that is no power of two.
Scene scene_of_both() {
  Scene scene;
  scene.target.width = 20;
  scene.target.height = 10;
  scene.viewport = {-3, 1, 20, 13};
  Draw window;
  window.vertices.resize(3);
  window.vertices[1].position = at(7 * Fixed::kOne, 3);
  window.vertices[2].position = at(5, 9 * Fixed::kOne);
  window.scissor = Viewport{1, 1, 2, 2};
  Draw clip;
  for (const ClipPosition& one : {ClipPosition{0.5F, -0.25F, 0.125F, 1},
                                  ClipPosition{-0.1F, 0.3F, 0, 1.5F}, ClipPosition{2.5F, -1, 1, 3}})
    clip.vertices.push_back(clip_vertex(one, scene.viewport));
  // 0.1 and 0.3 to their grid.
  for (Vertex& vertex : clip.vertices) vertex = moved_vertex(vertex, {}, scene.viewport);
  scene.draws = {window, clip};
  return scene;
}

TEST(Passes, OfAGridOfOneAreTheSceneItself) {
  Scene scene = scene_of_both();
  const Scene plain = scene;
  scene.supersampling = {{kCentre, 5}};
  const std::vector<Scene> passes = passes_of(scene);
  ASSERT_EQ(passes.size(), 1U);
  EXPECT_TRUE(same_scene(passes[0], plain));
  EXPECT_FALSE(same_scene(passes[0], scene));
}

TEST(Passes, AreNamedFromOne) {
  const Supersampling passes = {{at(Fixed::kOne / 4, -Fixed::kOne), 1}, {at(1, 0), 65536}};
  EXPECT_EQ(text_of_pass(passes, 0), "pass 1 of 2 (at 0.25, -1; weight 1)");
  EXPECT_EQ(text_of_pass(passes, 1), "pass 2 of 2 (at 0.0000152587890625, 0; weight 65536)");
}

TEST(Passes, OfASceneThatIsNotSupersampledAreNone) {
  EXPECT_THAT(passes_of(scene_of_both()), IsEmpty());
}

TEST(Passes, MoveWindowPositionsTheOtherWay) {
  Scene scene = scene_of_both();
  scene.supersampling = {{at(0, Fixed::kOne), 1}, {at(-Fixed::kOne, 3), 1}};
  const std::vector<Scene> passes = passes_of(scene);
  ASSERT_EQ(passes.size(), 2U);
  const auto position = [&](std::size_t k) { return passes[k].draws[0].vertices[1].position; };
  EXPECT_EQ(position(0), at(7 * Fixed::kOne + Fixed::kOne / 2, 3 - Fixed::kOne / 2));
  EXPECT_EQ(position(1), at(8 * Fixed::kOne + Fixed::kOne / 2, Fixed::kOne / 2));
}

TEST(Passes, ChangeNothingButPlaces) {
  Scene scene = scene_of_both();
  scene.supersampling = {{at(1, 2), 1}};
  Scene pass = pass_of(scene, 0);
  EXPECT_THAT(pass.supersampling, IsEmpty());
  Scene plain = scene;
  plain.supersampling.clear();
  EXPECT_FALSE(same_scene(pass, plain));
  for (std::size_t d = 0; d < 2; ++d)
    for (std::size_t v = 0; v < 3; ++v) {
      Vertex& moved = pass.draws[d].vertices[v];
      const Vertex& own = scene.draws[d].vertices[v];
      EXPECT_NE(moved.position, own.position);
      moved.position = own.position;
      if (!moved.clip) continue;
      moved.clip->x = own.clip->x;
      moved.clip->y = own.clip->y;
    }
  EXPECT_TRUE(same_scene(pass, plain));
}

TEST(Passes, MoveClipCoordinatesByKnownNumbers) {
  const Viewport viewport{5, -7, 16, 8};
  // w 2, moved by 1/4 and -1/2: 2 * 1/4 * 2 / 16 and -2 * 1/2 * 2 / 8.
  const Vertex moved = moved_vertex(clip_vertex({0.5F, 0.25F, 0.125F, 2}, viewport),
                                    at(Fixed::kOne / 4, -Fixed::kOne / 2), viewport);
  EXPECT_EQ(moved.clip, (ClipPosition{0.5625F, 0, 0.125F, 2}));
  EXPECT_FALSE(std::signbit(moved.clip->y));
  // 5 + 8 + 8 * 9/32 and -7 + 4.
  EXPECT_EQ(moved.position, at(15 * Fixed::kOne + Fixed::kOne / 4, -3 * Fixed::kOne));
  EXPECT_EQ(moved.w, 2);
}

TEST(Passes, RoundTiesToEven) {
  // w 1: n 2^-16 pixels are n 2^-30 of clip coordinates, n steps of the grid.
  const Viewport viewport{0, 0, 32768, 32768};
  const auto moved_by = [&](float x, std::int64_t raw) {
    const Vertex vertex = clip_vertex({x, 0, 0, 1}, viewport);
    return static_cast<double>(moved_vertex(vertex, at(raw, 0), viewport).clip->x) *
           std::ldexp(1.0, 30);
  };
  EXPECT_EQ(moved_by(0, 1), 1);
  EXPECT_EQ(moved_by(0, -3), -3);
  // Between 2^24 and 2^25 steps a float32 number has every second one.
  const float start = std::ldexp(1.0F, -6);
  EXPECT_EQ(moved_by(start, 1), std::ldexp(1.0, 24));
  EXPECT_EQ(moved_by(start, 2), std::ldexp(1.0, 24) + 2);
  EXPECT_EQ(moved_by(start, 3), std::ldexp(1.0, 24) + 4);
  EXPECT_EQ(moved_by(-start, -1), -std::ldexp(1.0, 24));
  EXPECT_EQ(moved_by(-start, -3), -std::ldexp(1.0, 24) - 4);
  // From just below 2^24 up to it.
  EXPECT_EQ(moved_by(std::nextafter(start, 0.0F), 1), std::ldexp(1.0, 24));
  // Thirds of steps, by a viewport whose size is no power of two: 4/3 and 8/3.
  const Viewport thirds{0, 0, 24576, 1};
  const Vertex vertex = clip_vertex({0, 0, 0, 1}, thirds);
  EXPECT_EQ(moved_vertex(vertex, at(1, 0), thirds).clip->x, std::ldexp(1.0F, -30));
  EXPECT_EQ(moved_vertex(vertex, at(2, 0), thirds).clip->x, 3 * std::ldexp(1.0F, -30));
}

// Is a number a float32 number and a multiple of 2^(e-30)?
bool is_on_grid(float value, float w) {
  const double steps = std::ldexp(static_cast<double>(value), 30 - std::ilogb(w));
  return steps == std::trunc(steps);
}

// Every number on the grid next to the result is at least as far from the exact one.
TEST(Passes, ClipCoordinatesAreTheNearestThatCanBeHeld) {
  std::mt19937_64 engine(7);
  const auto between = [&](std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(engine() % static_cast<std::uint64_t>(high - low + 1));
  };
  long inexact = 0;
  for (int round = 0; round < 20000; ++round) {
    const Viewport viewport{0, 0, static_cast<int>(between(1, 300)), 32767};
    const int exponent = static_cast<int>(between(-20, 19));
    const float w = std::ldexp(static_cast<float>(between(1 << 23, (1 << 24) - 1)), exponent - 23);
    const int lower = static_cast<int>(between(0, 30));
    const float x = std::ldexp(static_cast<float>(between(-(1 << 22), 1 << 22)),
                               std::max(exponent - 22 - lower, exponent - 30));
    const Point shift = at(between(-98304, 98304), between(-98304, 98304));
    const Vertex moved = moved_vertex(clip_vertex({x, x, 0, w}, viewport), shift, viewport);
    const auto check = [&](float result, Fixed by, int size) {
      EXPECT_TRUE(is_on_grid(result, w));
      const Rational exact = rational_of(x) + Rational(2 * by.raw(), 65536) * rational_of(w) / size;
      const Rational error = abs(Rational(rational_of(result) - exact));
      if (error != 0) ++inexact;
      for (const float other : {std::nextafter(result, -INFINITY), std::nextafter(result, INFINITY),
                                result - std::ldexp(1.0F, std::ilogb(w) - 30),
                                result + std::ldexp(1.0F, std::ilogb(w) - 30)})
        if (is_on_grid(other, w)) {
          EXPECT_LE(error, abs(Rational(rational_of(other) - exact)));
        }
    };
    check(moved.clip->x, shift.x, viewport.width);
    check(moved.clip->y, shift.y, viewport.height);
    EXPECT_EQ(moved.position, nearest_point(window_position(*moved.clip, viewport)));
  }
  EXPECT_GT(inexact, 10000);
}

TEST(Passes, VerticesMayLeaveTheirRange) {
  const Viewport viewport{0, 0, 8, 8};
  Vertex vertex;
  vertex.position = at(Fixed::kMaxCoordinate * Fixed::kOne, 0);
  EXPECT_TRUE(is_in_range(vertex));
  EXPECT_FALSE(is_in_range(moved_vertex(vertex, at(1, 0), viewport)));
  vertex = clip_vertex({1, -1, 0, 1}, viewport);
  EXPECT_TRUE(is_in_range(vertex));
  EXPECT_FALSE(is_in_range(moved_vertex(vertex, at(Fixed::kOne, 0), viewport)));
  EXPECT_FALSE(is_in_range(moved_vertex(vertex, at(0, -Fixed::kOne), viewport)));
}

TEST(Passes, WorkCountsPixelsGeneratedTexelsAndVertices) {
  Scene scene = scene_of_both();
  EXPECT_EQ(pass_work(scene), 0U);
  scene.supersampling = {{kCentre, 1}, {kCentre, 2}, {kCentre, 3}};
  EXPECT_EQ(pass_work(scene), 3U * (200 + 6));
  Texture texture;
  texture.levels = {{3, 2, std::vector<float>(24)}};
  scene.textures = {std::make_shared<const Texture>(texture)};
  EXPECT_EQ(pass_work(scene), 3U * (200 + 6));
  texture.generated = true;
  scene.textures.push_back(std::make_shared<const Texture>(texture));
  EXPECT_EQ(pass_work(scene), 3U * (200 + 6 + 6));
}

TEST(Passes, TellScenesApartAndAreInTheirWords) {
  Scene scene = scene_of_both();
  scene.supersampling = {{kCentre, 1}};
  EXPECT_THAT(scene_text(scene), testing::EndsWith(", 20x10, 1 pass"));
  Scene other = scene;
  EXPECT_TRUE(same_scene(scene, other));
  other.supersampling[0].weight = 2;
  EXPECT_FALSE(same_scene(scene, other));
  other = scene;
  other.supersampling[0].at.y = Fixed();
  EXPECT_FALSE(same_scene(scene, other));
  other.supersampling.push_back({kCentre, 1});
  EXPECT_THAT(scene_text(other), testing::EndsWith(", 20x10, 2 passes"));
}

}  // namespace
}  // namespace edgecase
