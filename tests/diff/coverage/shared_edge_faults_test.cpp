// SPDX-License-Identifier: MIT
//
// Which samples on common edges ruling 5 finds fault with, and that looking triangles up by their
// edges finds what looking at all pairs does.
#include "diff/coverage/shared_edge_faults.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "raster/rasterizer.h"
#include "rules/coverage/homogeneous_triangle.h"
#include "rules/coverage/triangle_fill.h"
#include "tests/diff/named_scenes.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/judging.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
using Faults = std::vector<SharedEdgeFault>;

bool is_same(const SharedEdgeFault& a, const SharedEdgeFault& b) {
  return std::tie(a.pixel, a.sample, a.first, a.second, a.hits) ==
         std::tie(b.pixel, b.sample, b.first, b.second, b.hits);
}

Faults faults(const Scene& scene, const Rendering& drawn) {
  const auto primitives = primitives_of(scene);
  return shared_edge_faults(primitives, match_coverage(primitives.size(), drawn, drawn), scene, 8);
}

// The same, each pair of primitives by itself.
Faults faults_of_all_pairs(const Scene& scene, const Rendering& drawn) {
  const auto primitives = primitives_of(scene);
  const auto coverage = match_coverage(primitives.size(), drawn, drawn);
  Faults all;
  for (std::size_t i = 0; i < primitives.size(); ++i)
    for (std::size_t j = i + 1; j < primitives.size(); ++j)
      for (const auto& fault :
           shared_edge_faults(std::vector{primitives[i], primitives[j]}, coverage, scene, 8))
        all.push_back(fault);
  return all;
}

Pairs neighbours_among_all_pairs(const std::vector<ScenePrimitive>& primitives) {
  Pairs pairs;
  for (std::size_t i = 0; i < primitives.size(); ++i)
    for (std::size_t j = i + 1; j < primitives.size(); ++j)
      if (primitives[i].kind == PrimitiveKind::triangle &&
          primitives[j].kind == PrimitiveKind::triangle &&
          shared_edge(nearest_triangle(primitives[i].positions),
                      nearest_triangle(primitives[j].positions)))
        pairs.emplace_back(i, j);
  return pairs;
}

// Triangles of three corners each among a few points, so that most edges have several neighbours,
// with all windings, twice the same, and without area.
Scene crowded_scene(RandomScenes& random, int triangles) {
  Scene scene = blank_scene(8, 8);
  for (int i = 0; i < triangles; ++i) {
    std::vector<Point> corners;
    for (int k = 0; k < 3; ++k) corners.push_back(at(2.5 * random.below(3), 2.5 * random.below(3)));
    scene.draws.push_back(make_draw(Primitive::triangles, corners, i));
  }
  return scene;
}

// Without one fragment in five of the first primitives.
Rendering thinned(Rendering drawn, RandomScenes& random, int primitives) {
  std::erase_if(drawn.fragments, [&](const Fragment& fragment) {
    return fragment.primitive < primitives && random.below(5) == 0;
  });
  return drawn;
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

TEST(SharedEdgeFaults, AreThoseOfAllPairsInTheirOrder) {
  RandomScenes random(32);
  std::size_t found = 0;
  for (int i = 0; i < 400; ++i) {
    Scene scene = crowded_scene(random, 12);
    if (i % 2 == 1) scene.draws[static_cast<std::size_t>(random.below(12))].cull = CullMode::back;
    const Rendering drawn = thinned(rasterize(scene, {}), random, 12);
    const Faults all = faults_of_all_pairs(scene, drawn);
    ASSERT_TRUE(std::ranges::equal(faults(scene, drawn), all, is_same)) << i;
    found += all.size();
  }
  EXPECT_GT(found, 200u);
}

TEST(SharedEdgeFaults, AreNotThoseOfTwoTrianglesThatAreDrawnAsExactDrawsThem) {
  RandomScenes random(34);
  std::size_t found = 0;
  for (int i = 0; i < 2000; ++i) {
    const Scene scene = crowded_scene(random, 12);
    const auto primitives = primitives_of(scene);
    const Rendering exact = rasterize(scene, {});
    const auto coverage =
        match_coverage(primitives.size(), exact, thinned(exact, random, random.below(6)));
    const Faults all = shared_edge_faults(primitives, coverage, scene, 8);
    const Faults fewer =
        shared_edge_faults(primitives, coverage, scene, 8, {centre_of_pixel()}, true);
    ASSERT_TRUE(std::ranges::equal(fewer, all, is_same)) << i;
    found += all.size();
  }
  EXPECT_GT(found, 200u);
}

TEST(Neighbours, AreAllPairsWithACommonEdge) {
  RandomScenes random(33);
  std::size_t found = 0;
  for (int i = 0; i < 400; ++i) {
    const Scene scene =
        i % 2 == 0 ? crowded_scene(random, 20) : random.next({10, Fixed::kOne / 2, 4, false});
    const auto primitives = primitives_of(scene);
    const Pairs all = neighbours_among_all_pairs(primitives);
    ASSERT_EQ(neighbours(primitives), all) << i;
    found += all.size();
  }
  EXPECT_GT(found, 200u);
}

// A hole has no tie order as its cause, though each triangle alone is drawn as by some order:
// orders give the sample to one of the two. What both follow is one.
TEST(SharedEdgeFaults, AHoleHasNoCauseThatIsNoneForBothTriangles) {
  const Scene& scene = scene_named("shared edge");
  const Rendering exact = rasterize(scene, {});
  const auto result_of = [&](const Rendering& rendered) { return judged(scene, rendered); };
  Policy other;
  other.rules["triangle.fill-rule"] = "right-bottom";
  const Result ordered = result_of(rasterize(scene, other));
  EXPECT_EQ(ordered.verdict, Verdict::convention);
  // The first triangle as one order has it, the second as exact: holes, or samples hit twice.
  for (const char* order : {"right-bottom", "right-top", "bottom-right", "left-bottom"}) {
    other.rules["triangle.fill-rule"] = order;
    const Rendering mixed = rasterize(scene, other);
    std::vector<Fragment> fragments;
    for (const Fragment& f : mixed.fragments)
      if (f.primitive == 0) fragments.push_back(f);
    for (const Fragment& f : exact.fragments)
      if (f.primitive != 0) fragments.push_back(f);
    const Result result = result_of(compose(scene, fragments));
    if (result.verdict != Verdict::violation) continue;
    for (const Disagreement& d : result.disagreements)
      EXPECT_FALSE(d.cause.rule() == RuleId::triangle_fill_rule &&
                   d.cause != "triangle.fill-rule=open" && d.cause != "triangle.fill-rule=closed")
          << order << text_of(d.cause);
  }
  // Illegal orders make holes and double hits for both, and are named.
  for (const char* order : {"open", "closed"}) {
    other.rules["triangle.fill-rule"] = order;
    const Result result = result_of(rasterize(scene, other));
    EXPECT_EQ(result.verdict, Verdict::violation);
    for (const Disagreement& d : result.disagreements)
      EXPECT_EQ(d.cause, std::string("triangle.fill-rule=") + order);
  }
}

}  // namespace
}  // namespace edgecase
