// SPDX-License-Identifier: MIT
//
// The accumulated image against the definition, slowly: for each pixel, all fragments of each pass
// are looked through for the last one there, and the sum is a quotient of integers. What is told
// must be a double that no other double beats. Passes are told in a second way, too: by shading a
// scene with vertices moved by hand.
#include <gtest/gtest.h>

#include "exact/interval.h"
#include "exact/rational.h"
#include "raster/rasterizer.h"
#include "tests/raster/random_scenes.h"

namespace edgecase {
namespace {

// The colour component that a pass shows at a pixel.
Rational shown(const Rendering& pass, const Target& target, int x, int y, std::size_t c) {
  Rational result = rational_of(target.clear[c]);
  int last = -1;
  for (const Fragment& fragment : pass.fragments)
    if (fragment.x == x && fragment.y == y && fragment.primitive >= last) {
      last = fragment.primitive;
      result = rational_of(fragment.color[c]);
    }
  return result;
}

Rational distance(double value, const Rational& exact) {
  return abs(Rational(rational_of(value) - exact));
}

struct Tally {
  long numbers = 0;
  long rounded = 0;
};

void check_image(const Scene& scene, const std::vector<Rendering>& passes,
                 const Rendering& reported, Tally& tally) {
  std::size_t i = 0;
  for (int y = 0; y < scene.target.height; ++y)
    for (int x = 0; x < scene.target.width; ++x)
      for (std::size_t c = 0; c < 4; ++c, ++i) {
        Rational sum = 0;
        Rational weights = 0;
        for (std::size_t k = 0; k < passes.size(); ++k) {
          const Rational weight = scene.supersampling[k].weight;
          sum += weight * shown(passes[k], scene.target, x, y, c);
          weights += weight;
        }
        const Rational exact = sum / weights;
        const double value = reported.accumulated.at(i);
        const Rational error = distance(value, exact);
        ++tally.numbers;
        if (error != 0) ++tally.rounded;
        ASSERT_LE(error, distance(next_above(value), exact)) << x << ", " << y << " " << c;
        ASSERT_LE(error, distance(next_below(value), exact)) << x << ", " << y << " " << c;
        ASSERT_EQ(reported.pixels.at(i), to_unorm8(value));
      }
  ASSERT_EQ(i, reported.accumulated.size());
  ASSERT_EQ(i, reported.pixels.size());
}

Scene moved_by_hand(Scene scene, Point place) {
  scene.supersampling.clear();
  for (Draw& draw : scene.draws)
    for (Vertex& vertex : draw.vertices) {
      vertex.position.x = Fixed::from_raw(vertex.position.x.raw() + 32768 - place.x.raw());
      vertex.position.y = Fixed::from_raw(vertex.position.y.raw() + 32768 - place.y.raw());
    }
  return scene;
}

TEST(SupersampleOracle, RandomScenesWithRandomPasses) {
  RandomScenes random(21);
  Tally tally;
  long fragments = 0;
  for (int round = 0; round < 120; ++round) {
    Scene scene = random.next({5, round % 2 == 0 ? 16384 : 256, 5, true});
    const int count = 1 + random.below(9);
    for (int k = 0; k < count; ++k) {
      const int step = random.below(2) == 0 ? 16384 : 1;
      const auto place = [&] {
        return Fixed::from_raw(-65536 + step * random.below(3 * 65536 / step + 1));
      };
      const Fixed x = place();
      scene.supersampling.push_back({{x, place()}, 1 + random.below(random.below(2) ? 9 : 70000)});
    }
    const Rendering reported = rasterize(scene, {});
    std::vector<Rendering> passes;
    for (const ShadingPass& pass : scene.supersampling) {
      passes.push_back(rasterize(moved_by_hand(scene, pass.at), {}));
      fragments += static_cast<long>(passes.back().fragments.size());
    }
    check_image(scene, passes, reported, tally);
    if (HasFatalFailure()) return;
  }
  EXPECT_EQ(tally.numbers, 120 * 5 * 5 * 4);
  EXPECT_GT(tally.rounded, 3000);
  EXPECT_GT(fragments, 7000);
}

}  // namespace
}  // namespace edgecase
