// SPDX-License-Identifier: MIT
#include "rules/samples/sample_mask.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace edgecase {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::uint32_t of4(AlphaToCoverage choice, float alpha) {
  return alpha_mask(static_cast<double>(alpha), 4, choice);
}

float above(float value) {
  return std::nextafter(value, kInfinity);
}
float below(float value) {
  return std::nextafter(value, -kInfinity);
}

// Each threshold by the float at it and its neighbour below.
TEST(AlphaToCoverage, ThresholdsOf4Samples) {
  const std::uint32_t masks[] = {1, 3, 7, 15};
  for (int s = 0; s < 4; ++s) {
    const std::uint32_t before = masks[s] >> 1;
    const float middle = static_cast<float>(2 * s + 1) / 8;
    EXPECT_EQ(of4(AlphaToCoverage::proportional, middle), masks[s]);
    EXPECT_EQ(of4(AlphaToCoverage::proportional, below(middle)), before);
    const float quarter = static_cast<float>(s) / 4;
    EXPECT_EQ(of4(AlphaToCoverage::above_quotient, above(quarter)), masks[s]);
    EXPECT_EQ(of4(AlphaToCoverage::above_quotient, quarter), before);
    const float fifth = static_cast<float>(s + 1) / 5;
    // A float is not a fifth: the one at or above it keeps the sample.
    const bool is_above = static_cast<double>(fifth) * 5 >= s + 1;
    EXPECT_EQ(of4(AlphaToCoverage::spread, is_above ? fifth : above(fifth)), masks[s]);
    EXPECT_EQ(of4(AlphaToCoverage::spread, is_above ? below(fifth) : fifth), before);
  }
}

TEST(AlphaToCoverage, AQuarterOf3SamplesIsAThresholdOfSpread) {
  EXPECT_EQ(alpha_mask(0.25, 3, AlphaToCoverage::spread), 1u);
  EXPECT_EQ(alpha_mask(std::nextafter(0.25, 0.0), 3, AlphaToCoverage::spread), 0u);
}

TEST(AlphaToCoverage, EndsAndNumbersBeyond) {
  for (AlphaToCoverage choice : values_of<AlphaToCoverage>())
    for (int samples : {2, 4, 8, 16}) {
      const std::uint32_t all = (1u << samples) - 1;
      for (double alpha : {1.0, 2.0, static_cast<double>(kInfinity)})
        EXPECT_EQ(alpha_mask(alpha, samples, choice), all) << name_of(choice);
      const std::uint32_t none = choice == AlphaToCoverage::ignored ? all : 0;
      for (double alpha : {0.0, -1.0, static_cast<double>(-kInfinity), static_cast<double>(kNone)})
        EXPECT_EQ(alpha_mask(alpha, samples, choice), none) << name_of(choice) << alpha;
    }
}

TEST(AlphaToCoverage, MoreAlphaKeepsNoFewerSamplesAndTheFirstOnes) {
  for (AlphaToCoverage choice : values_of<AlphaToCoverage>())
    for (int samples = 1; samples <= 16; ++samples) {
      std::uint32_t last = alpha_mask(0, samples, choice);
      for (int step = 1; step <= 1024; ++step) {
        const std::uint32_t mask = alpha_mask(step / 1024.0, samples, choice);
        EXPECT_EQ(mask & last, last);
        EXPECT_EQ(mask & (mask + 1), 0u);  // no gap
        last = mask;
        const int kept = std::popcount(mask);
        if (choice != AlphaToCoverage::ignored) {
          EXPECT_LT(std::abs(kept - samples * step / 1024.0), 1.001);
        }
        const SampleCounts counts = alpha_permitted(step / 1024.0, samples);
        EXPECT_LE(kept, counts.most);
        EXPECT_GE(kept, choice == AlphaToCoverage::ignored ? 0 : counts.least);
      }
    }
}

TEST(AlphaToCoverage, OnlyTheEndsAreDemanded) {
  const auto counts = [](Interval alpha) {
    const SampleCounts c = alpha_permitted(alpha, 4);
    return std::pair{c.least, c.most};
  };
  EXPECT_EQ(counts(0.0), (std::pair{0, 0}));
  EXPECT_EQ(counts({-1, 0}), (std::pair{0, 0}));
  EXPECT_EQ(counts({0, 1e-9}), (std::pair{0, 4}));
  EXPECT_EQ(counts({0.9, 1}), (std::pair{0, 4}));
  EXPECT_EQ(counts({1, 2}), (std::pair{4, 4}));
  EXPECT_EQ(counts(Interval::everything()), (std::pair{0, 4}));
}

// Less than one sample off: either whole number beside alpha n, and alpha n alone where it is one.
TEST(AlphaToCoverage, ProportionalIsLessThanASampleOff) {
  const auto kept_by = [](double alpha) {
    std::vector<int> kept;
    for (int count = 0; count <= 4; ++count)
      if (is_proportional(alpha, count, 4)) kept.push_back(count);
    return kept;
  };
  using Counts = std::vector<int>;
  EXPECT_EQ(kept_by(0), Counts{0});
  EXPECT_EQ(kept_by(0.1), (Counts{0, 1}));
  EXPECT_EQ(kept_by(0.5), Counts{2});
  EXPECT_EQ(kept_by(0.51), (Counts{2, 3}));
  EXPECT_EQ(kept_by(1), Counts{4});
  EXPECT_EQ(kept_by(7), Counts{4});
  // Every alternative that is open.
  for (const Alternative& alternative : alpha_to_coverage_rule().alternatives) {
    AlphaToCoverage choice{};
    ASSERT_TRUE(parse_name(alternative.name, choice));
    if (alternative.openness != Openness::open) continue;
    for (int samples = 1; samples <= 16; ++samples)
      for (int step = 1; step < 1024; ++step)
        EXPECT_TRUE(is_proportional(
            step / 1024.0, std::popcount(alpha_mask(step / 1024.0, samples, choice)), samples))
            << alternative.name;
  }
}

TEST(AlphaToCoverage, ByTheAlphasOfOthers) {
  using Alphas = std::array<double, 4>;
  const auto both = [](const Alphas& alphas) {
    return std::pair{mask_by_others(alphas), runs_by_others(alphas)};
  };
  // Where all agree it is as though each looked at its own.
  for (int i = 0; i <= 8; ++i) {
    const double alpha = i / 8.0;
    const auto [mask, runs] = both({alpha, alpha, alpha, alpha});
    const std::uint32_t own = alpha_mask(alpha, 4, AlphaToCoverage::above_quotient);
    EXPECT_EQ(mask, own) << alpha;
    // Sample 0 runs before any other.
    EXPECT_EQ(runs, own | 1u) << alpha;
  }
  // Its own alpha keeps no sample, and clears none.
  EXPECT_EQ(both({1, 0, 0, 0}), (std::pair{0u, 3u}));
  EXPECT_EQ(both({0, 1, 1, 1}), (std::pair{1u, 1u}));
  EXPECT_EQ(both({1, 1, 1, 0}), (std::pair{8u, 15u}));
  EXPECT_EQ(both({0.5, 1, 1, 1}), (std::pair{3u, 3u}));
}

TEST(AlphaToCoverage, NamesAreReadBack) {
  for (AlphaToCoverage choice : values_of<AlphaToCoverage>()) {
    AlphaToCoverage read = AlphaToCoverage::ignored;
    EXPECT_TRUE(parse_name(name_of(choice), read));
    EXPECT_EQ(read, choice);
  }
  AlphaToCoverage read = AlphaToCoverage::spread;
  EXPECT_FALSE(parse_name("dithered", read));
  EXPECT_EQ(read, AlphaToCoverage::spread);
}

}  // namespace
}  // namespace edgecase
