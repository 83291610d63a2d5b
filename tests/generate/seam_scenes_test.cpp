// SPDX-License-Identifier: MIT
//
// Seams that pass pixel centres at a hair: each edge that two triangles share passes one at 1 to 3
// units of the scene's grid, counted here pixel by pixel.
#include "generate/seam_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "model/scene.h"
#include "raster/rasterizer.h"
#include "tests/generate/scene_checks.h"

namespace edgecase {
namespace {

constexpr std::uint64_t kSeed = 7;
constexpr std::uint64_t kScenes = 2'000;

using Whole = std::int64_t;
using Corner = std::pair<Whole, Whole>;  // of a grid's steps

// Fraction bits that the coordinates need.
int bits_of(const Scene& scene) {
  Whole all = 0;
  for (const Vertex& vertex : scene.draws[0].vertices)
    all |= vertex.position.x.raw() | vertex.position.y.raw();
  return 16 - std::countr_zero(static_cast<std::uint64_t>(all));
}

// The triangles, in steps of the scene's grid.
std::vector<std::array<Corner, 3>> triangles_of(const Scene& scene) {
  const Whole step = Whole{1} << (16 - bits_of(scene));
  std::vector<std::array<Corner, 3>> triangles;
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    std::array<Corner, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point p = primitive.vertices[i]->position;
      corners[i] = {p.x.raw() / step, p.y.raw() / step};
    }
    triangles.push_back(corners);
  }
  return triangles;
}

// Edges that two triangles have, each once.
std::set<std::pair<Corner, Corner>> seams_of(const Scene& scene) {
  std::map<std::pair<Corner, Corner>, int> users;
  for (const auto& t : triangles_of(scene))
    for (std::size_t k = 0; k < 3; ++k) ++users[std::minmax(t[k], t[(k + 1) % 3])];
  std::set<std::pair<Corner, Corner>> seams;
  for (const auto& [edge, count] : users)
    if (count == 2) seams.insert(edge);
  return seams;
}

// The least edge function of a centre beside the seam that is not on it, in units.
Whole nearest_centre(const std::pair<Corner, Corner>& seam, Whole pixel) {
  auto [a, b] = seam;
  if (std::abs(b.first - a.first) < std::abs(b.second - a.second)) {
    std::swap(a.first, a.second);
    std::swap(b.first, b.second);
  }
  if (a.first > b.first) std::swap(a, b);
  const auto [ax, ay] = a;
  const auto [bx, by] = b;
  Whole least = INT64_MAX;
  for (Whole x = ax / pixel * pixel + pixel / 2; x <= bx; x += pixel) {
    if (x < ax) continue;
    const Whole near = ay + (by - ay) * (x - ax) / (bx - ax);
    for (Whole y : {near / pixel * pixel + pixel / 2, near / pixel * pixel - pixel / 2}) {
      const Whole units = std::abs((bx - ax) * (y - ay) - (by - ay) * (x - ax));
      if (units != 0) least = std::min(least, units);
    }
  }
  return least;
}

TEST(SeamScenes, PassACentreAtOneToThreeUnitsWithEachSeam) {
  std::set<Whole> units;
  for (std::uint64_t index = 0; index < kScenes; ++index) {
    const Scene scene = seam_scene(kSeed, Surface::fbo, index);
    const auto seams = seams_of(scene);
    ASSERT_FALSE(seams.empty()) << index;
    for (const auto& seam : seams) {
      units.insert(nearest_centre(seam, Whole{1} << bits_of(scene)));
      ASSERT_LE(*units.rbegin(), kMostSeamUnits) << index;
    }
  }
  EXPECT_EQ(units, (std::set<Whole>{1, 2, 3}));
}

TEST(SeamScenes, AreFunctionsOfSeedSurfaceAndIndexThatReachOpenGlExactly) {
  std::set<std::uint64_t> seen;
  for (const Surface surface : {Surface::fbo, Surface::window})
    for (std::uint64_t index = 0; index < kScenes; ++index) {
      const Scene scene = seam_scene(kSeed, surface, index);
      ASSERT_EQ(fault_of(scene, kMostSeamTarget), "") << index;
      ASSERT_TRUE(same_scene(scene, seam_scene(kSeed, surface, index)));
      seen.insert(fingerprint_of(scene));
    }
  EXPECT_EQ(seen.size(), 2 * kScenes);
}

// Counter-examples are named by seed and index.
TEST(SeamScenes, AreTheSameOnEveryMachine) {
  std::uint64_t sum = 0;
  for (std::uint64_t index = 0; index < kScenes; ++index)
    sum = sum * 31 + fingerprint_of(seam_scene(kSeed, Surface::fbo, index));
  EXPECT_EQ(sum, 2695785742914596233u);
}

TEST(SeamScenes, AreOfAllBitsSizesFormsAndWindings) {
  std::set<int> bits;
  std::set<int> targets;
  std::map<Primitive, int> primitives;
  int left = 0, right = 0, thin = 0, low = 0, high = 0;
  for (std::uint64_t index = 0; index < kScenes; ++index) {
    const Scene scene = seam_scene(kSeed, Surface::fbo, index);
    bits.insert(bits_of(scene));
    targets.insert(scene.target.width);
    ++primitives[scene.draws[0].primitive];
    for (const auto& [a, b, c] : triangles_of(scene)) {
      const Whole area =
          (b.first - a.first) * (c.second - a.second) - (b.second - a.second) * (c.first - a.first);
      ++(area > 0 ? left : right);
      const Whole length = std::max(std::abs(b.first - a.first), std::abs(b.second - a.second));
      if (std::abs(area) < length * 2 << bits_of(scene)) ++thin;
    }
    const Fixed third = Fixed::from_integer(scene.target.width / 4);
    const Point p = scene.draws[0].vertices[0].position;
    if (p.x < third && p.y < third) ++low;
    if (p.x > third + third + third && p.y > third + third + third) ++high;
  }
  EXPECT_EQ(bits.size(), 13u);  // 4 to 16
  EXPECT_EQ(*targets.begin(), 8);
  EXPECT_EQ(*targets.rbegin(), kMostSeamTarget);
  for (const Primitive primitive :
       {Primitive::triangles, Primitive::triangle_strip, Primitive::triangle_fan})
    EXPECT_GT(primitives[primitive], 200) << name_of(primitive);
  for (const int count : {left, right, thin}) EXPECT_GT(count, 500);
  for (const int count : {low, high}) EXPECT_GT(count, 20);
}

TEST(SeamScenes, SolveForEdgesThatPassACentre) {
  for (const Whole k : {-3, -2, -1, 1, 2, 3}) {
    const RawVector u{-41, 17};
    const RawVector v = beyond_centre(u, k, 2).value();
    EXPECT_EQ(u.x * v.y - u.y * v.x, k);
    EXPECT_GT(v.x, 61);
    EXPECT_LT(v.x, 103);
  }
  EXPECT_FALSE(beyond_centre({6, 9}, 1, 1));
  EXPECT_FALSE(beyond_centre({0, 4}, 2, 1));
}

}  // namespace
}  // namespace edgecase
