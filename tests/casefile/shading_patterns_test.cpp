// SPDX-License-Identifier: MIT
#include "casefile/scene/patterns.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace edgecase {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

constexpr std::uint64_t kSeeds[] = {0, 1, 2, 65535};

Point at(std::int64_t raw_x, std::int64_t raw_y) {
  return {Fixed::from_raw(raw_x), Fixed::from_raw(raw_y)};
}

// Which of n cells a coordinate lies in.
int cell_of(Fixed coordinate, int n) {
  return static_cast<int>(coordinate.raw() * n / Fixed::kOne);
}

bool within_pixel(Point p) {
  return p.x >= Fixed() && p.y >= Fixed() && p.x < Fixed::from_integer(1) &&
         p.y < Fixed::from_integer(1);
}

// Mirrored at the pixel's centre line.
Point mirrored_x(Point p) {
  return {Fixed::from_integer(1) - p.x, p.y};
}

TEST(ShadingPatterns, AGridHasTheCentresOfItsCells) {
  EXPECT_THAT(grid_pattern(1), ElementsAre(at(32768, 32768)));
  EXPECT_THAT(grid_pattern(2),
              ElementsAre(at(16384, 16384), at(49152, 16384), at(16384, 49152), at(49152, 49152)));
  // 65536/6 = 10922.67, and five times that 54613.33.
  EXPECT_THAT(grid_pattern(3)[0], at(10923, 10923));
  EXPECT_THAT(grid_pattern(3)[5], at(54613, 32768));
  for (int n = 1; n <= 32; ++n) {
    const Pattern grid = grid_pattern(n);
    ASSERT_THAT(grid, SizeIs(static_cast<std::size_t>(n * n)));
    for (int i = 0; i < n * n; ++i) {
      const Point p = grid[static_cast<std::size_t>(i)];
      const double centre = (2.0 * (i % n) + 1) / (2 * n) * 65536;
      EXPECT_LE(std::fabs(static_cast<double>(p.x.raw()) - centre), 0.5);
      EXPECT_EQ(cell_of(p.y, n), i / n);
      // Its mirror image is the grid itself.
      EXPECT_EQ(mirrored_x(p), grid[static_cast<std::size_t>(i / n * n + n - 1 - i % n)]);
    }
  }
}

TEST(ShadingPatterns, JitteredHasOneInEachCell) {
  for (int n = 1; n <= 32; ++n)
    for (const std::uint64_t seed : kSeeds) {
      const Pattern pattern = jittered_pattern(n, seed);
      ASSERT_THAT(pattern, SizeIs(static_cast<std::size_t>(n * n)));
      for (int i = 0; i < n * n; ++i) {
        const Point p = pattern[static_cast<std::size_t>(i)];
        EXPECT_TRUE(within_pixel(p));
        EXPECT_EQ(cell_of(p.x, n), i % n);
        EXPECT_EQ(cell_of(p.y, n), i / n);
      }
    }
}

TEST(ShadingPatterns, NRooksHasOneInEachRowAndColumn) {
  for (const int n : {1, 2, 3, 7, 16, 100, 1000, 1024})
    for (const std::uint64_t seed : kSeeds) {
      const Pattern pattern = n_rooks_pattern(n, seed);
      ASSERT_THAT(pattern, SizeIs(static_cast<std::size_t>(n)));
      std::set<int> rows;
      for (int i = 0; i < n; ++i) {
        const Point p = pattern[static_cast<std::size_t>(i)];
        EXPECT_TRUE(within_pixel(p));
        EXPECT_EQ(cell_of(p.x, n), i);
        rows.insert(cell_of(p.y, n));
      }
      EXPECT_THAT(rows, SizeIs(static_cast<std::size_t>(n)));
    }
}

// Each of the 24 arrangements of four rooks, about as often as the others.
TEST(ShadingPatterns, NRooksArrangesRowsInEveryWay) {
  std::map<std::vector<int>, int> counts;
  for (std::uint64_t seed = 0; seed < 4800; ++seed) {
    std::vector<int> rows;
    for (const Point p : n_rooks_pattern(4, seed)) rows.push_back(cell_of(p.y, 4));
    ++counts[rows];
  }
  EXPECT_THAT(counts, SizeIs(24));
  for (const auto& [rows, count] : counts) {
    EXPECT_GT(count, 140);
    EXPECT_LT(count, 260);
  }
}

TEST(ShadingPatterns, RandomReachesTheWholePixel) {
  const Pattern pattern = random_pattern(1024, 3);
  ASSERT_THAT(pattern, SizeIs(1024));
  std::set<int> cells;
  for (const Point p : pattern) {
    EXPECT_TRUE(within_pixel(p));
    cells.insert(8 * cell_of(p.y, 8) + cell_of(p.x, 8));
  }
  EXPECT_THAT(cells, SizeIs(64));
}

// The first words of SplitMix64 from the seed 0 are 0xe220a8397b1dcdaf and 0x6e789e6aa1b965f4.
TEST(ShadingPatterns, SeedsGiveTheSamePlacesEverywhere) {
  EXPECT_THAT(random_pattern(1, 0), ElementsAre(at(0xe220, 0x6e78)));
  EXPECT_THAT(jittered_pattern(1, 0), ElementsAre(at(0xe220, 0x6e78)));
  EXPECT_THAT(n_rooks_pattern(1, 0), ElementsAre(at(0xe220, 0x6e78)));
  EXPECT_NE(random_pattern(5, 1), random_pattern(5, 2));
  EXPECT_NE(jittered_pattern(5, 1), jittered_pattern(5, 2));
  EXPECT_NE(n_rooks_pattern(5, 1), n_rooks_pattern(5, 2));
  EXPECT_EQ(jittered_pattern(5, 1), jittered_pattern(5, 1));
}

TEST(Filters, ABoxOfAPixelTakesThePatternAsItIs) {
  for (const Pattern& pattern : {grid_pattern(3), random_pattern(20, 1), Pattern{at(0, 65535)}}) {
    const Supersampling passes = filtered(pattern, {});
    ASSERT_THAT(passes, SizeIs(pattern.size()));
    for (std::size_t k = 0; k < passes.size(); ++k)
      EXPECT_EQ(passes[k], (ShadingPass{pattern[k], 1}));
  }
}

std::vector<std::int64_t> weights_of(const Supersampling& passes) {
  std::vector<std::int64_t> weights;
  for (const ShadingPass& pass : passes) weights.push_back(pass.weight);
  return weights;
}

TEST(Filters, ATentFallsToTheNeighboursCentres) {
  // 2 x 2: at 1/4 and 3/4 of three pixels, distances 5/4, 3/4, 1/4, 1/4, 3/4, 5/4: quarters 1, 3,
  // 3, 1 of those within.
  const Supersampling passes = filtered(grid_pattern(2), {Kernel::tent, Fixed::from_integer(1)});
  std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t> found;
  for (const ShadingPass& pass : passes)
    found[{pass.at.x.raw() * 4 / 65536, pass.at.y.raw() * 4 / 65536}] = pass.weight;
  ASSERT_THAT(passes, SizeIs(16));
  const std::pair<int, int> quarters[] = {{-1, 1}, {1, 3}, {3, 3}, {5, 1}};
  for (const auto& [x, across] : quarters)
    for (const auto& [y, up] : quarters) EXPECT_EQ((found[{x, y}]), across * up * 4096);
  // Pixel by pixel, row by row: of the first one only the upper right place is near enough.
  EXPECT_EQ(passes[0].at, at(-16384, -16384));
  EXPECT_EQ(passes[1].at, at(16384, -16384));
}

TEST(Filters, ATentsEndCountsNothing) {
  const Supersampling passes = filtered(grid_pattern(1), {Kernel::tent, Fixed::from_integer(1)});
  EXPECT_THAT(passes, ElementsAre(ShadingPass{at(32768, 32768), 65536}));
  // Thirds of thirds of 2^16, at distances 0 and 1 of a radius 3/2: 65536, 21845.33, 7281.78.
  EXPECT_THAT(weights_of(filtered(grid_pattern(1), {Kernel::tent, Fixed::from_raw(98304)})),
              ElementsAre(7282, 21845, 7282, 21845, 65536, 21845, 7282, 21845, 7282));
}

TEST(Filters, ABoxOfThreePixelsCountsAllOfThemAlike) {
  const Supersampling passes = filtered(grid_pattern(2), {Kernel::box, Fixed::from_raw(98304)});
  EXPECT_THAT(passes, SizeIs(36));
  EXPECT_THAT(weights_of(passes), testing::Each(1));
  EXPECT_THAT(filtered(grid_pattern(1), {Kernel::box, Fixed::from_integer(1)}), SizeIs(9));
  EXPECT_THAT(filtered(grid_pattern(1), {Kernel::box, Fixed::from_raw(65535)}), SizeIs(1));
  EXPECT_THAT(filtered(grid_pattern(2), {Kernel::box, Fixed::from_raw(16384)}), SizeIs(4));
  EXPECT_THAT(filtered(grid_pattern(2), {Kernel::box, Fixed::from_raw(16383)}), SizeIs(0));
}

// exp(-2) and exp(-4) of 2^16 are 8869.33 and 1200.33.
TEST(Filters, AGaussianHasHalfItsRadiusAsDeviation) {
  EXPECT_THAT(weights_of(filtered(grid_pattern(1), {Kernel::gaussian, Fixed::from_integer(1)})),
              ElementsAre(1200, 8869, 1200, 8869, 65536, 8869, 1200, 8869, 1200));
  // At d = r/2, exp(-1/2) along one axis: 39749.7.
  const Supersampling one =
      filtered({at(49152, 32768)}, {Kernel::gaussian, Fixed::from_raw(32768)});
  EXPECT_THAT(one, ElementsAre(ShadingPass{at(49152, 32768), 39750}));
}

// exp(-2 d^2 / r^2) of 2^16 is below 1/2 beyond d^2 = 5.9 r^2: never within the radius. A tent's
// weight is where the sample is next to its end.
TEST(Filters, WeightsThatBecomeNothingAreLeftOut) {
  const ReconstructionFilter tent{Kernel::tent, Fixed::from_raw(32768)};
  EXPECT_THAT(filtered({at(1, 32768)}, tent), SizeIs(1));
  EXPECT_THAT(filtered({at(1, 1)}, tent), SizeIs(0));
  EXPECT_THAT(filtered({at(0, 32768)}, tent), SizeIs(0));
}

TEST(Filters, MirroredPatternsHaveMirroredWeights) {
  const Pattern pattern = random_pattern(200, 9);
  for (const Kernel kernel : {Kernel::box, Kernel::tent, Kernel::gaussian})
    for (const std::int64_t radius : {20000, 32768, 65536, 98304}) {
      const ReconstructionFilter filter{kernel, Fixed::from_raw(radius)};
      Pattern mirrored;
      for (const Point p : pattern) mirrored.push_back(mirrored_x(p));
      auto there = filtered(pattern, filter);
      auto back = filtered(mirrored, filter);
      const auto before = [](const ShadingPass& a, const ShadingPass& b) {
        return std::pair(a.at.x, a.at.y) < std::pair(b.at.x, b.at.y);
      };
      for (ShadingPass& pass : back) pass.at = mirrored_x(pass.at);
      std::ranges::sort(there, before);
      std::ranges::sort(back, before);
      EXPECT_EQ(there, back);
      EXPECT_FALSE(there.empty());
    }
}

}  // namespace
}  // namespace edgecase
