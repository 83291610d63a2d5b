// SPDX-License-Identifier: MIT
//
// What textureQueryLod tells as the level accessed, against its pseudo-code and against the picks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/rules/textures/level_settings.h"
#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// The pseudo-code of textureQueryLod, line by line.
double literal_accessed(double lambda, const Setting& s) {
  const double last = s.last - s.sampler.base_level;
  if (lambda < 0) lambda = 0;
  if (lambda > last) lambda = last;
  if (s.sampler.mipmap == MipFilter::none) return 0;
  if (s.sampler.mipmap == MipFilter::nearest) return std::ceil(lambda + 0.5) - 1;
  return lambda;
}

TEST(AccessedLevel, IsThatOfThePseudoCode) {
  for_each_setting([](const Setting& s) {
    if (s.rules.nearest != NearestLevel::down_at_ties || s.rules.weight != LevelWeight::exact)
      return;
    for (int i = -2 * kUnit; i <= 8 * kUnit; i += 8) {
      const double lambda = static_cast<double>(i) / kUnit;
      const Interval accessed = accessed_level(lambda, s.sampler, s.last, s.rules);
      ASSERT_EQ(accessed.low, literal_accessed(lambda, s));
      ASSERT_EQ(accessed.high, accessed.low);
    }
  });
}

// Where the texture is minified it is the level and its weight.
TEST(AccessedLevel, AgreesWithThePicks) {
  for_each_setting([](const Setting& s) {
    for (int i = kUnit / 2 + 1; i <= 8 * kUnit; ++i) {
      const double lambda = static_cast<double>(i) / kUnit;
      const LevelPick pick = picks_of(lambda, s).at(0);
      ASSERT_EQ(accessed_level(lambda, s.sampler, s.last, s.rules).low,
                pick.level - s.sampler.base_level + pick.weight.low)
          << lambda;
    }
  });
}

TEST(AccessedLevel, OfAnIntervalHoldsThoseOfItsPoints) {
  RandomNumbers random(2);
  for_each_setting([&](const Setting& s) {
    for (int i = 0; i < 50; ++i) {
      const double low = random.real(-2, 7);
      const double high = low + random.real(0, 3);
      const Interval all = accessed_level({low, high}, s.sampler, s.last, s.rules);
      for (const double lambda : {low, high, std::min(std::ceil(low), high),
                                  std::min(std::floor(low) + 0.5, high), (low + high) / 2})
        ASSERT_TRUE(lambda < low || holds(all, accessed_level(lambda, s.sampler, s.last, s.rules)));
      ASSERT_EQ(all.low, accessed_level(low, s.sampler, s.last, s.rules).low);
    }
  });
}

TEST(AccessedLevel, KnowsTiesSlackAndTheUnknown) {
  Setting s;
  s.sampler.mipmap = MipFilter::nearest;
  s.last = 4;
  s.rules.any_tie = true;
  EXPECT_EQ(accessed_level(1.5, s.sampler, s.last, s.rules).low, 1);
  EXPECT_EQ(accessed_level(1.5, s.sampler, s.last, s.rules).high, 2);
  s.sampler.mipmap = MipFilter::linear;
  s.rules.slack = 0x1p-8;
  EXPECT_EQ(accessed_level(1.5, s.sampler, s.last, s.rules).low, 1.5 - 0x1p-8);
  EXPECT_EQ(accessed_level(1.5, s.sampler, s.last, s.rules).high, 1.5 + 0x1p-8);
  EXPECT_EQ(accessed_level(4, s.sampler, s.last, s.rules).high, 4);
  EXPECT_EQ(accessed_level(kNone, s.sampler, s.last, s.rules).low, 0);
  EXPECT_EQ(accessed_level(kNone, s.sampler, s.last, s.rules).high, 4);
}

// A chain may end before the base level, where nothing is complete.
TEST(AccessedLevel, IsDefinedWhereTheBaseIsBeyondTheEnd) {
  Setting s;
  s.sampler.mipmap = MipFilter::linear;
  s.sampler.base_level = 2;
  s.last = 1;
  for (const double lambda : {-1.0, 0.5, 3.0}) {
    EXPECT_EQ(accessed_level(lambda, s.sampler, s.last, s.rules).low, 0);
    EXPECT_EQ(accessed_level(lambda, s.sampler, s.last, s.rules).high, 0);
  }
}

}  // namespace
}  // namespace edgecase
