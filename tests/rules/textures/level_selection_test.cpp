// SPDX-License-Identifier: MIT
//
// Which levels a level of detail selects, against the formulas of the specification in whole
// numbers: lambda runs through all multiples of 1/1024 from -2 to 8, under every filter.
#include "rules/textures/level_selection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "tests/rules/textures/level_settings.h"
#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

TEST(PickLevels, OfAnExactLambdaIsTheOneOfTheFormulas) {
  int settings = 0;
  for_each_setting([&](const Setting& s) {
    ++settings;
    for (int lambda = -2 * kUnit; lambda <= 8 * kUnit; ++lambda) {
      const LevelPicks picks = picks_of(static_cast<double>(lambda) / kUnit, s);
      const Expected expected = literal(lambda, s);
      ASSERT_EQ(picks.size(), 1u) << lambda;
      ASSERT_TRUE(same_levels(picks[0], expected)) << lambda;
      ASSERT_EQ(picks[0].weight.low, expected.weight) << lambda;
      ASSERT_EQ(picks[0].weight.high, expected.weight) << lambda;
    }
  });
  EXPECT_EQ(settings, 2 * 2 * 2 * 3 * (1 + 3 + 10));
}

// A base level of 2, levels up to 5, levels of detail up to 1.5.
TEST(Limited, TakesTheLimitsForOtherOnes) {
  Sampler set;
  set.base_level = 2;
  set.max_level = 5;
  set.max_lod = 1.5F;
  const auto has = [&](LevelLimits limits, int max_level, float max_lod) {
    Sampler expected = set;
    expected.max_level = max_level;
    expected.max_lod = max_lod;
    EXPECT_EQ(limited(set, limits), expected) << name_of(limits);
  };
  has(LevelLimits::as_set, 5, 1.5F);
  has(LevelLimits::max_level_as_max_lod, 1000, 1.5F);
  has(LevelLimits::max_lod_from_level_0, 5, -0.5F);
  has(LevelLimits::max_level_ignored, 1000, 1.5F);
  set.max_lod = 1000;
  has(LevelLimits::max_level_as_max_lod, 1000, 5);
}

// The doubles on either side of every border: no sum rounds a lambda onto it.
TEST(PickLevels, BesideATieIsOnItsSide) {
  Setting s;
  s.sampler.mipmap = MipFilter::nearest;
  s.last = 6;
  for (const NearestLevel tie : values_of<NearestLevel>())
    for (int k = 0; k < 6; ++k) {
      s.rules.nearest = tie;
      EXPECT_EQ(picks_of(next_below(k + 0.5), s).at(0).level, k);
      EXPECT_EQ(picks_of(next_above(k + 0.5), s).at(0).level, k + 1);
    }
  EXPECT_TRUE(picks_of(0, s).at(0).magnified);
  EXPECT_FALSE(picks_of(next_above(0), s).at(0).magnified);
}

// An interval yields what its points yield, no more and no less.
TEST(PickLevels, OfAnIntervalAreThoseOfItsPoints) {
  RandomNumbers random(1);
  for_each_setting([&](const Setting& s) {
    for (int i = 0; i < 60; ++i) {
      const int unit = random.one_in(2) ? 1 : kUnit / 2;
      const int low = unit * static_cast<int>(random.integer(-kUnit / unit, 7 * kUnit / unit));
      const int high = low + unit * static_cast<int>(random.integer(0, 2 * kUnit / unit));
      const LevelPicks picks =
          picks_of({static_cast<double>(low) / kUnit, static_cast<double>(high) / kUnit}, s);
      std::vector<Interval> weights(picks.size(), Interval(2, -1));
      for (int lambda = low; lambda <= high; ++lambda) {
        const Expected expected = literal(lambda, s);
        const auto found = std::ranges::find_if(
            picks, [&](const LevelPick& pick) { return same_levels(pick, expected); });
        ASSERT_NE(found, picks.end()) << low << " " << high << " " << lambda;
        ASSERT_TRUE(found->weight.contains(expected.weight)) << low << " " << high << " " << lambda;
        Interval& reached = weights[static_cast<std::size_t>(found - picks.begin())];
        reached = hull(reached, expected.weight);
      }
      for (std::size_t k = 0; k < picks.size(); ++k) {
        ASSERT_LE(weights[k].low, weights[k].high) << "no point yields pick " << k;
        // The points are 1/1024 apart; a fraction comes as near to 0 and to 1 as it likes.
        const double apart = s.rules.weight == LevelWeight::narrow ? 8.0 / kUnit : 1.0 / kUnit;
        ASSERT_LE(weights[k].low - picks[k].weight.low, apart);
        ASSERT_LE(picks[k].weight.high - weights[k].high, apart);
      }
    }
  });
}

TEST(PickLevels, ComeInTheOrderOfLambda) {
  Setting s;
  s.sampler.mipmap = MipFilter::linear;
  s.last = 3;
  const LevelPicks picks = picks_of({-1, 9}, s);
  ASSERT_EQ(picks.size(), 5u);
  EXPECT_TRUE(picks[0].magnified);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(picks[static_cast<std::size_t>(k + 1)].level, k);
  EXPECT_EQ(picks[1].weight.low, next_above(0));
  EXPECT_EQ(picks[2].weight.low, 0);
  EXPECT_EQ(picks[2].weight.high, 1);
  EXPECT_EQ(picks[4].next, 3);
  EXPECT_EQ(picks[4].weight.high, 0);
}

// The fraction comes as near to 1 as lambda to the next level; what is cut to a grid does not.
TEST(PickLevels, WeightsReachTheNextLevelWithLambda) {
  Setting s;
  s.sampler.mipmap = MipFilter::linear;
  s.last = 6;
  const auto highest = [&](Interval lambda, LevelWeight choice) {
    s.rules.weight = choice;
    return picks_of(lambda, s).at(0).weight.high;
  };
  for (const double high : {2.0, 2.5, 3.25}) {
    EXPECT_EQ(highest({1.5, high}, LevelWeight::exact), 1);
    EXPECT_EQ(highest({1.5, high}, LevelWeight::nearest_8), 1);
    EXPECT_EQ(highest({1.5, high}, LevelWeight::floor_8), next_above(255.0 / 256));
  }
  EXPECT_EQ(highest({1.25, 1.75}, LevelWeight::exact), 0.75);
}

TEST(PickLevels, AnyTieFindsBothLevels) {
  Setting s;
  s.sampler.mipmap = MipFilter::nearest;
  s.last = 4;
  s.rules.any_tie = true;
  for (const NearestLevel tie : values_of<NearestLevel>()) {
    s.rules.nearest = tie;
    for (int k = 0; k <= 5; ++k) {
      std::set<int> levels;
      for (const LevelPick& pick : picks_of(k + 0.5, s)) levels.insert(pick.level);
      EXPECT_EQ(levels, (std::set{std::min(k, 4), std::min(k + 1, 4)}));
      EXPECT_EQ(picks_of(k + 0.25, s).size(), 1u);
    }
  }
}

TEST(PickLevels, AnyTieFindsBothSidesOfTheCrossover) {
  Setting s;
  s.sampler.magnify = Filter::linear;
  s.rules.any_tie = true;
  EXPECT_EQ(picks_of(0, s).size(), 2u);
  EXPECT_TRUE(picks_of(0, s).at(0).magnified);
  EXPECT_FALSE(picks_of(0, s).at(1).magnified);
  EXPECT_EQ(picks_of(next_below(0), s).size(), 1u);
  EXPECT_EQ(picks_of(next_above(0), s).size(), 1u);
  s.sampler.mipmap = MipFilter::linear;
  s.last = 4;
  s.rules.crossover = Crossover::by_filters;
  const LevelPicks picks = picks_of(0.5, s);
  ASSERT_EQ(picks.size(), 2u);
  EXPECT_TRUE(picks[0].magnified);
  EXPECT_EQ(picks[1].weight.low, 0.5);
  EXPECT_EQ(picks[1].weight.high, 0.5);
}

TEST(PickLevels, SlackWidensWeightsWithinZeroToOne) {
  Setting s;
  s.sampler.mipmap = MipFilter::linear;
  s.last = 4;
  s.rules.slack = 0x1p-8;
  const auto weights = [&](double lambda) { return picks_of(lambda, s).at(0).weight; };
  EXPECT_EQ(weights(1.5).low, 0.5 - 0x1p-8);
  EXPECT_EQ(weights(1.5).high, 0.5 + 0x1p-8);
  EXPECT_EQ(weights(1).low, 0);
  EXPECT_EQ(weights(1).high, 0x1p-8);
  EXPECT_EQ(weights(2 - 0x1p-9).high, 1);
  EXPECT_EQ(weights(5).high, 0);
}

TEST(PickLevels, AreDefinedForEverything) {
  for_each_setting([](const Setting& s) {
    const LevelPicks near = picks_of(-kInfinity, s);
    ASSERT_EQ(near.size(), 1u);
    ASSERT_TRUE(near[0].magnified);
    const LevelPicks far = picks_of(kInfinity, s);
    ASSERT_EQ(far.size(), 1u);
    const bool chooses = s.sampler.mipmap != MipFilter::none;
    ASSERT_EQ(far[0].level, chooses ? s.last : s.sampler.base_level);
    ASSERT_EQ(far[0].next, far[0].level);
    ASSERT_EQ(picks_of(1e300, s).at(0).level, far[0].level);
    // Every level is possible where nothing is known, and the first pick is the base level.
    const LevelPicks unknown = picks_of(kNone, s);
    ASSERT_TRUE(unknown.front().magnified);
    ASSERT_EQ(unknown.back().level, far[0].level);
    ASSERT_EQ(unknown.size(), picks_of(Interval::everything(), s).size());
  });
}

// How each weight is off at worst, in steps of 1/256: the band of ruling 22 is less than one.
TEST(LevelWeights, AreOffByWhatTheirNamesSay) {
  const auto worst = [](LevelWeight choice) {
    Setting s;
    s.sampler.mipmap = MipFilter::linear;
    s.last = 4;
    s.rules.weight = choice;
    double most = 0;
    for (int i = 1; i < 8 * kUnit; ++i) {
      const double fraction = i / (8.0 * kUnit);
      most = std::max(most, std::fabs(picks_of(fraction, s).at(0).weight.low - fraction));
    }
    return most * 256;
  };
  EXPECT_EQ(worst(LevelWeight::exact), 0);
  EXPECT_LT(worst(LevelWeight::floor_8), 1);
  EXPECT_EQ(worst(LevelWeight::nearest_8), 0.5);
  EXPECT_GT(worst(LevelWeight::floor_4), 15.9);
  EXPECT_LT(worst(LevelWeight::floor_4), 16);
  EXPECT_EQ(worst(LevelWeight::nearest_4), 8);
  EXPECT_GT(worst(LevelWeight::floor_3), 31.9);
  EXPECT_EQ(worst(LevelWeight::nearest_3), 16);
  EXPECT_NEAR(worst(LevelWeight::narrow), 112, 0.1);
  EXPECT_EQ(worst(LevelWeight::whole), 128);
  EXPECT_EQ(worst(LevelWeight::one_at_ties), 128);
}

TEST(LevelWeights, AreDistinguished) {
  std::set<std::tuple<double, double, double>> results;
  for (const LevelWeight choice : values_of<LevelWeight>()) {
    Setting s;
    s.sampler.mipmap = MipFilter::linear;
    s.last = 4;
    s.rules.weight = choice;
    const auto weight_at = [&](double lambda) { return picks_of(lambda, s).at(0).weight.low; };
    results.insert({weight_at(0.5), weight_at(0.73), weight_at(0.3)});
  }
  EXPECT_EQ(results.size(), values_of<LevelWeight>().size());
}

Texture texture_of(int width, int height, bool chain) {
  Texture texture;
  const int count = chain ? level_count(width, height) : 1;
  for (int k = 0; k < count; ++k)
    texture.levels.push_back({level_size(width, k), level_size(height, k), {}});
  return texture;
}

TEST(LastLevel, IsTheEndOfTheChainOrMaxLevel) {
  Sampler sampler;
  EXPECT_EQ(last_level(sampler, texture_of(64, 16, true)), 6);
  EXPECT_EQ(last_level(sampler, texture_of(5, 100, true)), 6);
  EXPECT_EQ(last_level(sampler, texture_of(2, 1, true)), 1);
  sampler.base_level = 2;
  EXPECT_EQ(last_level(sampler, texture_of(64, 16, true)), 6);
  sampler.max_level = 4;
  EXPECT_EQ(last_level(sampler, texture_of(64, 16, true)), 4);
  sampler.max_level = 2;
  EXPECT_EQ(last_level(sampler, texture_of(64, 16, true)), 2);
  sampler.max_level = 1;  // which is refused elsewhere
  EXPECT_EQ(last_level(sampler, texture_of(64, 16, true)), 2);
}

TEST(LastLevel, OfOneLevelIsTheBaseUnlessMoreAreGenerated) {
  const Sampler sampler;
  Texture texture = texture_of(64, 16, false);
  EXPECT_EQ(last_level(sampler, texture), 0);
  texture.generated = true;
  EXPECT_EQ(last_level(sampler, texture), 6);
  EXPECT_EQ(last_level(sampler, Texture{}), 0);
}

}  // namespace
}  // namespace edgecase
