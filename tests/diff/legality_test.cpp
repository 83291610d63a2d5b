// SPDX-License-Identifier: MIT
//
// What legality is computed from: the bits that count, shared edges one by one.
#include "diff/legality.h"

#include <gtest/gtest.h>

#include "diff/coverage_diff.h"
#include "raster/rasterizer.h"
#include "tests/diff/named_scenes.h"
#include "tests/raster/random_scenes.h"

namespace edgecase {
namespace {

TEST(LatitudeBits, AreAtLeastFourAndNoFinerThanCoordinates) {
  EXPECT_EQ(latitude_bits(-1), 4);
  EXPECT_EQ(latitude_bits(0), 4);
  EXPECT_EQ(latitude_bits(4), 4);
  EXPECT_EQ(latitude_bits(8), 8);
  EXPECT_EQ(latitude_bits(16), 16);
  EXPECT_EQ(latitude_bits(24), 16);
}

// The same rendering is a violation of a renderer that reports 8 bits, and not of one that reports
// 4: snapping to 4 bits is what the latter announced.
TEST(LatitudeBits, DecideWhetherACoarseSnapIsAViolation) {
  const Scene& scene = scene_named("triangles off the grid");
  Policy coarse;
  coarse.rules["subpixel.snap"] = "4-half-even";
  const Rendering rendered = rasterize(scene, coarse);
  EXPECT_EQ(compare_and_judge(scene, rendered, 8).verdict, Verdict::violation);
  EXPECT_EQ(compare_and_judge(scene, rendered, 4).verdict, Verdict::convention);
}

std::vector<SharedEdgeFault> faults(const Scene& scene, const Rendering& drawn) {
  const auto primitives = primitives_of(scene);
  return shared_edge_faults(primitives, match_coverage(primitives.size(), drawn, drawn),
                            scene.target, 8);
}

TEST(SharedEdgeFaults, ArePlacedWhereTheHoleIs) {
  const Scene& scene = scene_named("shared edge");
  Rendering drawn = rasterize(scene, {});
  EXPECT_TRUE(faults(scene, drawn).empty());
  std::erase_if(drawn.fragments, [](const Fragment& f) { return f.x == 7 && f.y == 7; });
  const auto found = faults(scene, drawn);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].pixel, (PixelPosition{7, 7}));
  EXPECT_EQ(found[0].first, 0);
  EXPECT_EQ(found[0].second, 1);
  EXPECT_EQ(found[0].hits, 0);
}

// Whatever conforming order a renderer follows, meshes of random triangles have no faults.
TEST(SharedEdgeFaults, AreNotFoundInWhatTheEightOrdersDraw) {
  RandomScenes random(31);
  for (int i = 0; i < 3000; ++i) {
    const Scene scene = random.next({10, Fixed::kOne / 2, 4, false});
    for (const char* order : {"left-bottom", "right-bottom", "bottom-left", "top-right"}) {
      Policy policy;
      policy.rules["triangle.fill-rule"] = order;
      ASSERT_TRUE(faults(scene, rasterize(scene, policy)).empty()) << i << " " << order;
    }
  }
}

}  // namespace
}  // namespace edgecase
