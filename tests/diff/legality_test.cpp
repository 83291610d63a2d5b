// SPDX-License-Identifier: MIT
//
// What legality is computed from: the bits that count, what lines tell.
#include "diff/coverage/legality.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "diff/compare.h"
#include "diff/coverage/coverage_diff.h"
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

// What judge() needs of a line, and what clusters and reports tell: the snaps under which some
// ruling on lines fails, the first clause that is broken, where on the line each pixel lies.
TEST(LinesInAComparison, TellTheirSnapsTheirFirstClauseAndPlaces) {
  const Scene& scene = scene_named("strip x-major");
  const Rendering exact = rasterize(scene, {});
  const auto compared = [&](const Rendering& drawn) {
    return compare(scene, {}, exact, drawn, {8});
  };
  const auto is_illegal_as_given = [](const Result& result) {
    const auto& snaps = result.illegal_line_snaps;
    return std::find(snaps.begin(), snaps.end(), "none") != snaps.end();
  };
  EXPECT_TRUE(compared(exact).illegal_line_snaps.empty());
  // Twice at the joint: legal line by line.
  Rendering doubled = exact;
  doubled.fragments.push_back(fragment_at(scene, 0, 8, 6));
  const Result joint = compared(compose(scene, doubled.fragments));
  EXPECT_TRUE(is_illegal_as_given(joint));
  ASSERT_EQ(joint.disagreements.size(), 1u);
  EXPECT_EQ(joint.disagreements[0].rule, "line.joint");
  EXPECT_EQ(joint.disagreements[0].situation,
            "line, x-major right and up, last pixel, end at the centre of its diamond");
  // A stray far away breaks ruling 1; the joint, doubled too, comes after it.
  doubled.fragments.push_back(fragment_at(scene, 0, 1, 14));
  const Result both = compared(compose(scene, doubled.fragments));
  EXPECT_TRUE(is_illegal_as_given(both));
  for (const Disagreement& d : both.disagreements) EXPECT_EQ(d.rule, "line.diamond-exit");
  ASSERT_EQ(both.evidence.size(), 1u);
  EXPECT_EQ(both.evidence[0].broken_clause,
            "pixel (1, 14) has no diamond-exit fragment within one unit");
  // Ruling 1 alone.
  Rendering stray = exact;
  stray.fragments.push_back(fragment_at(scene, 1, 1, 14));
  EXPECT_TRUE(is_illegal_as_given(compared(compose(scene, stray.fragments))));
}

}  // namespace
}  // namespace edgecase
