// SPDX-License-Identifier: MIT
//
// Fragments that are shaded together are those that are shaded alone, to the bit.
#include "raster/fragment_runs.h"

#include <gtest/gtest.h>

#include "tests/raster/random_scenes.h"
#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

void expect_as_alone(const ScenePrimitive& triangle, const PrimitiveAttributes& attributes,
                     std::span<const PixelPosition> pixels) {
  FragmentRuns runs(triangle, attributes, pixels);
  for (const PixelPosition pixel : pixels) {
    const Fragment& together = runs.next();
    const Fragment alone = shade(triangle, attributes, pixel);
    ASSERT_EQ(together.x, pixel.x);
    ASSERT_EQ(together.y, pixel.y);
    ASSERT_EQ(together.primitive, alone.primitive);
    ASSERT_EQ(together.color, alone.color);
    ASSERT_EQ(together.depth, alone.depth);
  }
}

TEST(FragmentRuns, AreTheFragmentsOfEachPixel) {
  RandomNumbers numbers(51);
  for (int round = 0; round < 60; ++round) {
    Scene scene = blank_scene(40, 12);
    const Point corners[] = {at(0.5, 0.5), at(39.5, 1 + round % 10), at(3.25, 11.75)};
    scene.draws = {make_draw(Primitive::triangles, corners)};
    Draw& draw = scene.draws[0];
    draw.interpolation = round % 3 == 0 ? Interpolation::noperspective : Interpolation::smooth;
    if (round % 4 == 0) draw.polygon_offset = PolygonOffset{.factor = 4, .units = -2};
    for (Vertex& vertex : draw.vertices) {
      vertex.z = Fixed::from_raw(numbers.integer(0, Fixed::kOne));
      if (round % 2 == 0) vertex.w = static_cast<float>(numbers.integer(1, 9));
      for (float& c : vertex.color) c = static_cast<float>(numbers.integer(0, 64)) / 64;
    }
    const std::vector<ScenePrimitive> primitives = primitives_of(scene);
    const PrimitiveAttributes attributes =
        attributes_of(primitives[0], RuleChoices{}, scene.target);
    // Rows of every length, with gaps, and pixels that do not touch.
    std::vector<PixelPosition> pixels;
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 40; ++x)
        if (numbers.integer(0, round % 12) != 1) pixels.push_back({x, y});
    expect_as_alone(primitives[0], attributes, pixels);
    if (HasFatalFailure()) FAIL() << round;
  }
}

}  // namespace
}  // namespace edgecase
