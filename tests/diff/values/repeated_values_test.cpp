// SPDX-License-Identifier: MIT
//
// Fragments that tell what the one before them told: looked at once where that says all, and every
// one where it does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "diff/compare.h"
#include "raster/rasterizer.h"
#include "tests/diff/values/value_mutants.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

// One colour and one depth all over.
Scene constant_scene() {
  Scene scene = value_scene("linear triangle");
  scene.details = {};
  for (Vertex& vertex : scene.draws[0].vertices) {
    vertex.color = scene.draws[0].vertices[0].color;
    vertex.z = scene.draws[0].vertices[0].z;
  }
  return scene;
}

Result compared(const Scene& scene, const Rendering& exact, const Rendering& reported) {
  return compare(scene, {}, exact, stored(scene, reported), {8});
}

TEST(RepeatedValues, AnyOneOfManyThatIsOffIsNamedAndAllAreCounted) {
  const Scene scene = constant_scene();
  const Rendering exact = rasterize(scene, {});
  const std::size_t count = exact.fragments.size();
  ASSERT_GT(count, 10u);
  for (const std::size_t victim : {std::size_t{0}, std::size_t{1}, count / 2, count - 1}) {
    Rendering reported = exact;
    reported.fragments[victim].color[1] = float_above(reported.fragments[victim].color[1]);
    const Result result = compared(scene, exact, reported);
    EXPECT_TRUE(result.disagreements.empty());
    ASSERT_EQ(result.values.size(), 1u) << victim;
    EXPECT_EQ(result.values[0].attribute, "color");
    EXPECT_EQ(result.values[0].compared, count);
    EXPECT_EQ(result.values[0].components, 4 * count);
    ASSERT_EQ(result.values[0].differing.size(), 1u);
    EXPECT_EQ(result.values[0].differing[0].x, exact.fragments[victim].x);
    EXPECT_EQ(result.values[0].differing[0].y, exact.fragments[victim].y);
  }
}

TEST(RepeatedValues, ADepthOfItsOwnIsNamedToo) {
  const Scene scene = constant_scene();
  const Rendering exact = rasterize(scene, {});
  Rendering reported = exact;
  Fragment& last = reported.fragments.back();
  last.depth = float_below(last.depth);
  const Result result = compared(scene, exact, reported);
  ASSERT_EQ(result.values.size(), 1u);
  EXPECT_EQ(result.values[0].attribute, "depth");
  EXPECT_EQ(result.values[0].compared, exact.fragments.size());
  EXPECT_EQ(result.values[0].differing.size(), 1u);
}

// What is right at one fragment says nothing of others where the attribute changes.
TEST(RepeatedValues, OfAGradientEachIsHeldAgainstItsOwnPlace) {
  const Scene scene = value_scene("linear triangle");
  const Rendering exact = rasterize_for_comparison(scene, {});
  for (const bool color : {true, false}) {
    Rendering reported = exact;
    for (Fragment& fragment : reported.fragments)
      (color ? fragment.color[0] : fragment.depth) =
          color ? exact.fragments[0].color[0] : exact.fragments[0].depth;
    const Result result = compared(scene, exact, reported);
    const auto off = std::ranges::count_if(result.disagreements, [&](const Disagreement& d) {
      return d.rule == (color ? "attribute.smooth" : "fragment.depth");
    });
    EXPECT_GT(static_cast<std::size_t>(off), exact.fragments.size() / 2) << color;
  }
}

// The first of two primitives is told as it is, the second in the first one's colour.
TEST(RepeatedValues, OfAnotherPrimitiveIsAnotherMatter) {
  Scene scene = constant_scene();
  scene.draws.push_back(scene.draws[0]);
  for (Vertex& vertex : scene.draws[1].vertices) vertex.color = {0.25f, 0.5f, 0.75f, 1};
  const Rendering exact = rasterize(scene, {});
  Rendering reported = exact;
  for (Fragment& fragment : reported.fragments) fragment.color = exact.fragments[0].color;
  const Result result = compared(scene, exact, reported);
  std::size_t off = 0;
  for (const Disagreement& d : result.disagreements)
    if (d.rule == "attribute.smooth") {
      EXPECT_EQ(d.primitive, 1);
      ++off;
    }
  EXPECT_EQ(2 * off, exact.fragments.size());
}

}  // namespace
}  // namespace edgecase
