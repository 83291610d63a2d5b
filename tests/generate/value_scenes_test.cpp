// SPDX-License-Identifier: MIT
#include "generate/value_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "casefile/case_writer.h"
#include "casefile/scene/viewport.h"
#include "model/scene.h"

namespace edgecase {
namespace {

constexpr std::uint64_t kScenes = 400;

Scene scene_at(const ValueMode& mode, std::uint64_t index) {
  return value_scene({1, Surface::fbo, mode}, index);
}

void expect_exact(const Scene& scene) {
  const Viewport& viewport = scene.viewport;
  for (const Draw& draw : scene.draws)
    for (const Vertex& v : draw.vertices) {
      EXPECT_FALSE(find_inexactness(v.position.x, {viewport.x, viewport.width}, 'x', v.w));
      EXPECT_FALSE(find_inexactness(v.position.y, {viewport.y, viewport.height}, 'y', v.w));
      EXPECT_FALSE(find_depth_inexactness(v.z, v.w));
      for (float c : v.color) EXPECT_TRUE(std::isfinite(c));
    }
}

TEST(ValueScenes, ReachOpenGlExactly) {
  for (const ValueMode& mode : all_value_modes())
    for (std::uint64_t i = 0; i < kScenes; ++i) {
      const Scene scene = scene_at(mode, i);
      expect_exact(scene);
      for (const ScenePrimitive& primitive : primitives_of(scene)) {
        EXPECT_EQ(has_perspective(primitive), mode.perspective);
        EXPECT_EQ(primitive.kind, mode.kind);
        EXPECT_EQ(primitive.state->interpolation, mode.interpolation);
      }
    }
}

TEST(ValueScenes, CanBeWrittenAsCases) {
  for (const ValueMode& mode : all_value_modes())
    for (std::uint64_t i = 0; i < 10; ++i) {
      const Scene scene = scene_at(mode, i);
      EXPECT_TRUE(
          case_text(scene, {"", "t", "w", {"attribute.smooth"}, "", "", {}}).diagnostics.empty());
    }
}

TEST(ValueScenes, DependOnSeedSurfaceAndIndexAlone) {
  const ValueMode mode = all_value_modes()[1];
  EXPECT_TRUE(same_scene(scene_at(mode, 5), scene_at(mode, 5)));
  EXPECT_FALSE(same_scene(scene_at(mode, 5), scene_at(mode, 6)));
  EXPECT_FALSE(same_scene(scene_at(mode, 5), value_scene({2, Surface::fbo, mode}, 5)));
  Scene of_window = value_scene({1, Surface::window, mode}, 5);
  of_window.target.surface = Surface::fbo;
  EXPECT_FALSE(same_scene(scene_at(mode, 5), of_window));
}

float ratio_of(const Draw& draw) {
  const auto [least, most] = std::minmax_element(
      draw.vertices.begin(), draw.vertices.begin() + vertices_of(kind_of(draw.primitive)),
      [](const Vertex& a, const Vertex& b) { return a.w < b.w; });
  return most->w / least->w;
}

TEST(ValueScenes, SpreadColorsAndW) {
  std::size_t constant = 0, crossing = 0, beyond = 0, tiny = 0, huge = 0, equal_w_not_1 = 0;
  std::size_t mild = 0, strong = 0, extreme = 0;
  for (const ValueMode& mode : all_value_modes())
    for (std::uint64_t i = 0; i < kScenes; ++i) {
      const Scene scene = scene_at(mode, i);
      const Draw& draw = scene.draws[0];
      const float a = draw.vertices[0].color[0];
      const float b = draw.vertices[1].color[0];
      const float size = std::max(std::fabs(a), std::fabs(b));
      if (a == b) ++constant;
      if (a * b < 0) ++crossing;
      if (size > 1) ++beyond;
      if (size > 1e6f) ++huge;
      if (a != b && std::fabs(a - b) < 1e-4f * size) ++tiny;
      const float ratio = ratio_of(draw);
      if (ratio == 1 && draw.vertices[0].w != 1) ++equal_w_not_1;
      if (ratio > 1 && ratio <= 8) ++mild;
      if (ratio > 8 && ratio <= 256) ++strong;
      if (ratio > 256) ++extreme;
    }
  for (const std::size_t count :
       {constant, crossing, beyond, tiny, huge, equal_w_not_1, mild, strong, extreme})
    EXPECT_GT(count, 100u);
}

}  // namespace
}  // namespace edgecase
