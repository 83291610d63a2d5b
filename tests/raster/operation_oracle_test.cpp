// SPDX-License-Identifier: MIT
//
// Random scenes with random fragment operations against the literal oracle: the fragments of the
// same scene without operations, one after another, sample by sample.
#include "tests/raster/operation_oracle.h"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "raster/rasterizer.h"
#include "tests/raster/random_operations.h"

namespace edgecase {
namespace {

// The scene as if nobody knew of operations.
Scene without_operations(Scene scene) {
  for (Draw& draw : scene.draws) draw.operations = {};
  scene.target.stencil = StencilFormat::none;
  scene.target.clear_depth = 1;
  return scene;
}

using Key = std::tuple<int, int, int, std::uint32_t>;  // x, y, primitive, coverage

// The depth of each sample of each primitive: of a shader that runs for each of them.
std::map<Key, double> depths_of_samples(Scene scene) {
  for (Draw& draw : scene.draws) draw.multisampling.location = AttributeLocation::sample;
  std::map<Key, double> depths;
  for (const Fragment& f : rasterize(scene, {}).fragments)
    depths[{f.x, f.y, f.primitive, f.coverage}] = f.depth;
  return depths;
}

std::vector<oracle::Stored> replayed(const Scene& scene, const Rendering& reported) {
  const auto primitives = primitives_of(scene);
  const auto depths = depths_of_samples(without_operations(scene));
  std::vector<oracle::Stored> samples(reported.hits.size(), oracle::cleared(scene.target));
  for (const Fragment& f : reported.fragments) {
    const ScenePrimitive& primitive = primitives[static_cast<std::size_t>(f.primitive)];
    const bool multisampled = is_multisampled(*primitive.state, scene.target);
    for (int s = 0; s < reported.samples; ++s) {
      const std::uint32_t bit = std::uint32_t{1} << s;
      if (multisampled && (f.coverage & bit) == 0) continue;
      const double depth = multisampled ? depths.at({f.x, f.y, f.primitive, bit}) : f.depth;
      oracle::arrive({f.color, depth, oracle::faces_front(primitive)}, primitive.state->operations,
                     scene.target, samples[reported.sample_index(f.x, f.y, s)]);
    }
  }
  return samples;
}

struct Tally {
  long fragments = 0;
  long hits = 0;
  long unlike = 0;  // samples in which operations made a difference
};

void expect_same_fragments(const Rendering& a, const Rendering& b) {
  ASSERT_EQ(a.fragments.size(), b.fragments.size());
  for (std::size_t i = 0; i < a.fragments.size(); ++i) {
    const Fragment &f = a.fragments[i], &g = b.fragments[i];
    ASSERT_EQ(std::tie(f.x, f.y, f.primitive, f.coverage, f.depth, f.color),
              std::tie(g.x, g.y, g.primitive, g.coverage, g.depth, g.color));
  }
}

void check(const Scene& scene, Tally& tally) {
  const Rendering ours = rasterize(scene, {});
  const Rendering reported = rasterize(without_operations(scene), {});
  expect_same_fragments(ours, reported);
  const auto& colors = ours.samples > 1 ? ours.sample_pixels : ours.pixels;
  const auto& plain = ours.samples > 1 ? reported.sample_pixels : reported.pixels;
  const std::vector<oracle::Stored> expected = replayed(scene, reported);
  ASSERT_EQ(ours.hits.size(), expected.size());
  ASSERT_EQ(ours.depths.size(), scene.target.depth == DepthFormat::none ? 0 : expected.size());
  ASSERT_EQ(ours.stencils.size(),
            scene.target.stencil == StencilFormat::none ? 0 : expected.size());
  tally.fragments += static_cast<long>(ours.fragments.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const oracle::Stored& sample = expected[i];
    ASSERT_EQ(ours.hits[i], sample.hits) << i;
    if (!ours.depths.empty()) {
      ASSERT_EQ(ours.depths[i], sample.depth) << i;
    }
    if (!ours.stencils.empty()) {
      ASSERT_EQ(ours.stencils[i], sample.stencil) << i;
    }
    for (std::size_t c = 0; c < 4; ++c) ASSERT_EQ(colors[4 * i + c], sample.color[c]) << i;
    tally.hits += sample.hits;
    tally.unlike += colors[4 * i] != plain[4 * i];
  }
}

TEST(OperationOracle, RandomScenes) {
  RandomScenes random(81);
  Tally tally;
  for (int round = 0; round < 1000 && !HasFatalFailure(); ++round) {
    Scene scene = random.next({6, 16384, 5, true});
    give_operations(scene, random);
    check(scene, tally);
  }
  EXPECT_GT(tally.fragments, 15000);
  EXPECT_GT(tally.fragments - tally.hits, 4000);
  EXPECT_GT(tally.unlike, 7000);
}

TEST(OperationOracle, RandomMultisampledScenes) {
  RandomScenes random(82);
  Tally tally;
  for (int round = 0; round < 250 && !HasFatalFailure(); ++round) {
    Scene scene = random.next({5, 16384, 5, true});
    give_operations(scene, random);
    scene.target.samples = 2 << random.below(3);
    for (Draw& draw : scene.draws) {
      draw.multisampling.enabled = random.below(4) != 0;
      if (random.below(3) == 0) draw.multisampling.mask = 0b10110101;
    }
    check(scene, tally);
  }
  EXPECT_GT(tally.fragments, 4000);
  EXPECT_GT(tally.unlike, 5000);
}

}  // namespace
}  // namespace edgecase
