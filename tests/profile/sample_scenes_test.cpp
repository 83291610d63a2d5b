// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "generate/random_scenes.h"
#include "generate/random_shapes.h"
#include "profile/samples/samples.h"
#include "raster/rasterizer.h"
#include "rules/samples/sample_placement.h"

namespace edgecase {
namespace {

class MultisampledKinds : public ::testing::TestWithParam<MultisampledKind> {};

TEST_P(MultisampledKinds, HaveTiesWithSamplesInHalfOfTheScenes) {
  for (const int samples : {2, 4, 8}) {
    const SamplePositions positions = standard_pattern(samples);
    std::size_t ties = 0;
    for (std::uint64_t i = 0; i < 1000; ++i) {
      const Scene scene = random_multisampled_scene(3, GetParam(), positions, i);
      EXPECT_EQ(scene.target.samples, samples);
      EXPECT_LE(scene.target.width, kMostMultisampledTarget);
      for (const Vertex& vertex : scene.draws[0].vertices)
        EXPECT_TRUE(strictly_inside(vertex.position, scene.target.width));
      if (has_tie(scene, positions)) ++ties;
    }
    EXPECT_GT(ties, 400u);
    EXPECT_LT(ties, 800u);
  }
}

TEST_P(MultisampledKinds, AreTheSameEveryTimeAndOthersOfAnotherSeed) {
  const SamplePositions positions = standard_pattern(4);
  std::size_t same = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    const auto of = [&](std::uint64_t seed) {
      return random_multisampled_scene(seed, GetParam(), positions, i)
          .draws[0]
          .vertices[0]
          .position;
    };
    EXPECT_EQ(of(1), of(1));
    if (of(1) == of(2)) ++same;
  }
  EXPECT_LT(same, 30u);
}

INSTANTIATE_TEST_SUITE_P(SampleScenes, MultisampledKinds,
                         ::testing::Values(MultisampledKind::triangle, MultisampledKind::line,
                                           MultisampledKind::wide_line),
                         [](const auto& one) {
                           return one.param == MultisampledKind::triangle ? "triangle"
                                  : one.param == MultisampledKind::line   ? "line"
                                                                          : "wide_line";
                         });

// Every probe's sample lies on the boundary, in every direction and on every part of it.
TEST(SampleScenes, LineSideProbesAreTies) {
  for (const int samples : {2, 4, 16}) {
    const SamplePositions positions = standard_pattern(samples);
    std::set<std::pair<LineSide, LineDirection>> seen;
    for (const LineSideProbe& probe : line_side_probes(positions)) {
      seen.emplace(probe.side, probe.direction);
      CoverageChoice choice;
      const auto covers = [&](const char* ties) {
        choice.ties = *find_tie_rule(ties);
        const auto primitives = primitives_of(probe.scene);
        const auto pixels =
            covered_samples(primitives[0], probe.scene.target, choice, positions)[probe.sample];
        return std::find(pixels.begin(), pixels.end(), probe.pixel) != pixels.end();
      };
      EXPECT_FALSE(covers("open"));
      EXPECT_TRUE(covers("closed"));
    }
    // Diagonals have ends alone.
    EXPECT_EQ(seen.size(), 4u * 12 + 2u * 4);
  }
}

TEST(SampleScenes, AlphasLieOnBothSidesOfEveryThreshold) {
  for (const int samples : {2, 4, 8, 16}) {
    const std::vector<float> alphas = probing_alphas(samples);
    EXPECT_TRUE(std::is_sorted(alphas.begin(), alphas.end()));
    EXPECT_EQ(alphas.front(), 0);
    EXPECT_EQ(alphas.back(), 1);
    for (const AlphaToCoverage choice : values_of<AlphaToCoverage>()) {
      std::set<std::uint32_t> masks;
      for (const float alpha : alphas)
        masks.insert(alpha_mask(static_cast<double>(alpha), samples, choice));
      const int expected = choice == AlphaToCoverage::ignored ? 1 : samples + 1;
      EXPECT_EQ(masks.size(), static_cast<std::size_t>(expected));
    }
  }
}

TEST(SampleScenes, ResolveScenesHaveSamplesOfDifferentColours) {
  const Rendering rendering = rasterize(resolve_scene(1, 4, 0), {});
  const std::size_t plane = rendering.pixels.size();
  std::size_t different = 0;
  for (std::size_t i = 0; i < plane; ++i)
    if (rendering.sample_pixels[i] != rendering.sample_pixels[plane + i]) ++different;
  EXPECT_GT(different, plane * 9 / 10);
}

}  // namespace
}  // namespace edgecase
