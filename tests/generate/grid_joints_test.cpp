// SPDX-License-Identifier: MIT
//
// Grid joints: each pair meets bit-identically, on the grid, and they differ.
#include "generate/grids.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <tuple>

#include "scene_checks.h"

namespace edgecase {
namespace {

bool lies_on_grid(Fixed coordinate) {
  return coordinate.raw() % (Fixed::kOne / 16) == 0 && coordinate > Fixed() &&
         coordinate < Fixed::from_integer(16);
}

TEST(GridJoints, MeetOnTheGrid) {
  std::set<std::tuple<std::int64_t, std::int64_t>> joints;
  int at_halves = 0;
  int half_wide = 0;
  for (std::uint64_t index = 0; index < 100; ++index) {
    const Scene scene = grid_joint_scene(3, Surface::window, index);
    EXPECT_EQ(fault_of(scene), "");
    EXPECT_EQ(scene.target.surface, Surface::window);
    ASSERT_EQ(scene.draws.size(), 1u);
    EXPECT_EQ(scene.draws[0].primitive, Primitive::lines);
    if (scene.draws[0].line_width == Fixed::from_raw(Fixed::kOne / 2)) ++half_wide;
    const auto& vertices = scene.draws[0].vertices;
    ASSERT_EQ(vertices.size(), 4u * kGridJointsOfScene);
    for (std::size_t i = 0; i < vertices.size(); i += 4) {
      for (std::size_t k = i; k < i + 4; ++k)
        EXPECT_TRUE(lies_on_grid(vertices[k].position.x) && lies_on_grid(vertices[k].position.y));
      const Point joint = vertices[i + 1].position;
      EXPECT_EQ(joint, vertices[i + 2].position);
      joints.insert({joint.x.raw(), joint.y.raw()});
      if (joint.x.raw() % (Fixed::kOne / 2) == 0 && joint.y.raw() % (Fixed::kOne / 2) == 0)
        ++at_halves;
    }
  }
  EXPECT_GT(joints.size(), 700u);
  EXPECT_GT(at_halves, 700);
  EXPECT_NEAR(half_wide, 25, 15);
}

TEST(GridJoints, AreThoseOfTheirSeed) {
  const auto first_of = [](std::uint64_t seed, std::uint64_t index) {
    return grid_joint_scene(seed, Surface::fbo, index).draws[0].vertices[0].position;
  };
  EXPECT_EQ(first_of(3, 5), first_of(3, 5));
  EXPECT_NE(first_of(3, 5), first_of(4, 5));
  EXPECT_NE(first_of(3, 5), first_of(3, 6));
}

}  // namespace
}  // namespace edgecase
