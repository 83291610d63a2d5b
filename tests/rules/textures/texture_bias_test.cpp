// SPDX-License-Identifier: MIT
//
// Biases of levels of detail, and their clamping.
#include "rules/textures/level_of_detail.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Sampler biased(float bias) {
  Sampler sampler;
  sampler.lod_bias = bias;
  return sampler;
}

Lookup lookup_of(LookupKind kind, float value) {
  Lookup lookup;
  lookup.kind = kind;
  lookup.value = value;
  return lookup;
}

double lambda_prime(float sampler_bias, const Lookup& lookup, BiasChoice choice) {
  const Interval result = with_bias(1.25, biased(sampler_bias), lookup, choice);
  EXPECT_EQ(result.low, result.high);
  return result.low;
}

TEST(Bias, IsTheSamplersAndTheShaders) {
  const BiasChoice as_set = BiasChoice::as_set;
  EXPECT_EQ(lambda_prime(0.5F, lookup_of(LookupKind::implicit, 9), as_set), 1.75);
  EXPECT_EQ(lambda_prime(0.5F, lookup_of(LookupKind::bias, 2), as_set), 3.75);
  EXPECT_EQ(lambda_prime(0.5F, lookup_of(LookupKind::lod, 9), as_set), 1.75);
  EXPECT_EQ(lambda_prime(0.5F, lookup_of(LookupKind::gradients, 9), as_set), 1.75);
}

TEST(Bias, IsClampedAsASum) {
  const BiasChoice as_set = BiasChoice::as_set;
  EXPECT_EQ(lambda_prime(15, lookup_of(LookupKind::bias, 1), as_set), 17.25);
  EXPECT_EQ(lambda_prime(15, lookup_of(LookupKind::bias, 2), as_set), 17.25);
  EXPECT_EQ(lambda_prime(-15, lookup_of(LookupKind::bias, -2), as_set), -14.75);
  EXPECT_EQ(lambda_prime(16, lookup_of(LookupKind::bias, -20), as_set), -2.75);
  EXPECT_EQ(lambda_prime(15, lookup_of(LookupKind::bias, 2), BiasChoice::unclamped), 18.25);
}

// 8.14.1 lets terms beyond the limit, 2 at least, be clamped anyhow.
TEST(Bias, BeyondTheLimitEachTermMayBeClampedOrNot) {
  const auto permitted = [](float sampler, float shader) {
    return with_permitted_bias(1.25, biased(sampler), lookup_of(LookupKind::bias, shader));
  };
  // Within it nothing is open.
  for (const auto& [sampler, shader] :
       {std::pair{1.5F, 0.5F}, std::pair{-2.0F, 1.0F}, std::pair{0.0F, -2.0F}}) {
    const Interval exact = permitted(sampler, shader);
    EXPECT_EQ(exact.low, exact.high);
    EXPECT_EQ(exact.low, 1.25 + static_cast<double>(sampler) + static_cast<double>(shader));
  }
  // From 2 to what both are together; and what comes out may be clamped from 14 on.
  EXPECT_EQ(permitted(3, 0).low, 3.25);
  EXPECT_EQ(permitted(3, 0).high, 4.25);
  EXPECT_EQ(permitted(1.5F, 1).low, 3.25);
  EXPECT_EQ(permitted(1.5F, 1).high, 3.75);
  EXPECT_EQ(permitted(10, 9).low, 3.25);
  EXPECT_EQ(permitted(10, 9).high, 20.25);
  EXPECT_EQ(permitted(-15, -15).low, -28.75);
  EXPECT_EQ(permitted(-15, -15).high, -0.75);
  // One is clamped, and the other is not.
  EXPECT_EQ(permitted(16, -12).low, 1.25 - 10);
  EXPECT_EQ(permitted(16, -12).high, 1.25 + 14);
  EXPECT_EQ(with_permitted_bias(19, biased(0), {}).low, 14);
  EXPECT_EQ(with_permitted_bias(19, biased(0), {}).high, 19);
  // All ways to clamp at all limits from 2 on are held.
  for (const double limit : {2.0, 3.5, 15.0, 16.0, 1e9})
    for (const float sampler : {-9.0F, 0.5F, 2.5F, 12.0F})
      for (const float shader : {-14.0F, -1.0F, 3.0F, 15.5F}) {
        const auto at = [&](double term) { return std::clamp(term, -limit, limit); };
        const double t = double{sampler}, s = double{shader};
        for (const double way : {at(t + s), t + s, at(t) + at(s), at(at(t) + at(s)), at(t) + s})
          EXPECT_TRUE(permitted(sampler, shader).contains(1.25 + way)) << limit << " " << t << s;
      }
}

// Up to the limit that a renderer tells nothing is clamped.
TEST(Bias, TheRenderersOwnLimitTakesThePlaceOfTheLeast) {
  const auto permitted = [](float sampler, float shader, double limit) {
    return with_permitted_bias(1.25, biased(sampler), lookup_of(LookupKind::bias, shader),
                               {limit, false});
  };
  EXPECT_EQ(permitted(3, 0, 4).low, 4.25);
  EXPECT_EQ(permitted(3, 0, 4).high, 4.25);
  EXPECT_EQ(permitted(3, 2, 4).low, 5.25);
  EXPECT_EQ(permitted(3, 2, 4).high, 6.25);
  EXPECT_EQ(permitted(-7, 1, 4).low, -4.75);
  EXPECT_EQ(permitted(-7, 1, 4).high, -1.75);
}

TEST(Bias, AlternativesDiffer) {
  const Lookup none;
  const Lookup gradients = lookup_of(LookupKind::gradients, 0);
  const BiasChoice more = BiasChoice::half_a_level_more;
  EXPECT_EQ(lambda_prime(0.25F, none, more), 2);
  EXPECT_EQ(lambda_prime(16, lookup_of(LookupKind::bias, 16), more), 17.75);
  EXPECT_EQ(lambda_prime(0.25F, none, BiasChoice::not_of_gradients), 1.5);
  EXPECT_EQ(lambda_prime(0.25F, gradients, BiasChoice::not_of_gradients), 1.25);
  // 0.3 is 76.8 steps; halves go away from 0.
  const BiasChoice rounded = BiasChoice::sampler_nearest_8;
  EXPECT_EQ(lambda_prime(0.3F, none, rounded), 1.25 + 77.0 / 256);
  EXPECT_EQ(lambda_prime(15.3F, none, rounded), 1.25 + 3917.0 / 256);
  EXPECT_EQ(lambda_prime(2.5F / 256, none, rounded), 1.25 + 3.0 / 256);
  EXPECT_EQ(lambda_prime(-2.5F / 256, none, rounded), 1.25 - 3.0 / 256);
  EXPECT_EQ(lambda_prime(0, lookup_of(LookupKind::bias, 0.3F), rounded),
            lambda_prime(0, lookup_of(LookupKind::bias, 0.3F), BiasChoice::as_set));
  EXPECT_EQ(values_of<BiasChoice>().size(), lod_bias_rule().alternatives.size());
}

TEST(Bias, RoundsOutwards) {
  RandomNumbers random(4);
  for (int i = 0; i < 20'000; ++i) {
    const double base = random.real(-8, 8);
    const auto of_sampler = static_cast<float>(random.attribute(7));
    const auto of_shader = static_cast<float>(random.attribute(7));
    const Interval result = with_bias(base, biased(of_sampler),
                                      lookup_of(LookupKind::bias, of_shader), BiasChoice::as_set);
    const Wide sum =
        static_cast<Wide>(base) + static_cast<Wide>(of_sampler) + static_cast<Wide>(of_shader);
    ASSERT_TRUE(holds(result, sum));
    ASSERT_LE(width_of(result), 0x1p-48);
  }
}

TEST(Bias, IsDefinedForEverything) {
  const auto none = static_cast<float>(kNone);
  for (const BiasChoice choice : values_of<BiasChoice>()) {
    EXPECT_TRUE(is_everything(with_bias(kNone, biased(1), {}, choice)));
    EXPECT_EQ(with_bias(-kInfinity, biased(1), {}, choice).high, -kInfinity);
    EXPECT_EQ(with_bias(kInfinity, biased(1), {}, choice).low, kInfinity);
    EXPECT_FALSE(
        std::isnan(with_bias(0, biased(none), lookup_of(LookupKind::bias, none), choice).low));
  }
  EXPECT_EQ(with_bias(0, biased(none), {}, BiasChoice::as_set).low, -16);
  EXPECT_EQ(with_bias(0, biased(none), {}, BiasChoice::as_set).high, 16);
}

TEST(Clamp, IsToMinAndMax) {
  Sampler sampler;
  sampler.min_lod = -1.5F;
  sampler.max_lod = 3.25F;
  EXPECT_EQ(clamped(-2, sampler).high, -1.5);
  EXPECT_EQ(clamped(-1.25, sampler).low, -1.25);
  EXPECT_EQ(clamped(4, sampler).low, 3.25);
  EXPECT_EQ(clamped({-9, 9}, sampler).low, -1.5);
  EXPECT_EQ(clamped({-9, 9}, sampler).high, 3.25);
  EXPECT_EQ(clamped(-kInfinity, sampler).low, -1.5);
  EXPECT_EQ(clamped(kInfinity, sampler).high, 3.25);
  EXPECT_EQ(clamped(kNone, sampler).low, -1.5);
  EXPECT_EQ(clamped(kNone, sampler).high, 3.25);
}

}  // namespace
}  // namespace edgecase
