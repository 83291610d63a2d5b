// SPDX-License-Identifier: MIT
//
// supersample.accumulation: what each alternative makes of known numbers, and ruling 36 against
// float32 sums in every rounding mode.
#include "rules/samples/resolve.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace edgecase {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Supersampling weighing(const std::vector<std::int64_t>& weights) {
  Supersampling passes;
  for (const std::int64_t weight : weights) passes.push_back({{}, weight});
  return passes;
}

TEST(Accumulation, OfKnownNumbers) {
  const std::vector<double> shown = {4, -1, 0.5};
  const Supersampling passes = weighing({1, 2, 5});
  const auto by = [&](Accumulation choice) { return accumulated(shown, passes, choice); };
  EXPECT_EQ(by(Accumulation::exact_mean), 4.5 / 8);
  EXPECT_EQ(by(Accumulation::float32_sum), 4.5 / 8);
  EXPECT_EQ(by(Accumulation::clamped), 3.5 / 8);
  // 0.5 becomes 128/255, the even one of two.
  EXPECT_EQ(by(Accumulation::bytes), (255 + 5 * 128) / 255.0 / 8);
  EXPECT_EQ(by(Accumulation::unweighted), 3.5 / 3);
  EXPECT_EQ(by(Accumulation::sum), 4.5);
}

TEST(Accumulation, RoundsWhatSinglePrecisionCannotHold) {
  // 2^24 + 1 is no float32 number, and the 1 is lost; added first, it is not.
  const std::vector<double> large_first = {0x1p24, 1, 1};
  const std::vector<double> large_last = {1, 1, 0x1p24};
  const Supersampling passes = weighing({1, 1, 2});
  EXPECT_EQ(accumulated(large_first, weighing({1, 1, 1}), Accumulation::float32_sum),
            static_cast<double>(0x1p24F / 3));
  EXPECT_EQ(accumulated(large_last, passes, Accumulation::float32_sum), (0x1p25 + 2) / 4 - 0.5);
  EXPECT_EQ(accumulated(large_last, passes, Accumulation::exact_mean), (0x1p25 + 2) / 4);
}

TEST(Accumulation, NamesAreRead) {
  for (const Accumulation choice : values_of<Accumulation>()) {
    Accumulation read = Accumulation::sum;
    EXPECT_TRUE(parse_name(name_of(choice), read));
    EXPECT_EQ(read, choice);
  }
  Accumulation read = Accumulation::clamped;
  EXPECT_FALSE(parse_name("mean", read));
  EXPECT_EQ(read, Accumulation::clamped);
}

// In one rounding mode of the processor.
double sum_in_mode(const std::vector<double>& shown, const Supersampling& passes, int mode) {
  std::fesetround(mode);
  volatile float sum = 0;
  volatile float total = 0;
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const volatile float product =
        static_cast<float>(shown[k]) * static_cast<float>(passes[k].weight);
    sum = sum + product;
    total = total + static_cast<float>(passes[k].weight);
  }
  const volatile float mean = sum / total;
  std::fesetround(FE_TONEAREST);
  return static_cast<double>(mean);
}

TEST(Accumulation, Ruling36PermitsEveryRoundingOfFloat32) {
  std::mt19937_64 random(36);
  std::uniform_real_distribution<float> uniform(-1, 1);
  int off = 0;
  for (int round = 0; round < 3000; ++round) {
    const std::size_t count = 1 + random() % (round % 10 == 0 ? 1024 : 20);
    std::vector<double> shown;
    std::vector<std::int64_t> weights;
    for (std::size_t k = 0; k < count; ++k) {
      const int exponent = static_cast<int>(random() % (round % 3 == 0 ? 40 : 4));
      shown.push_back(static_cast<double>(std::ldexp(uniform(random), exponent - 20)));
      weights.push_back(1 + static_cast<std::int64_t>(random() % (round % 2 ? 9 : 1 << 20)));
    }
    const Supersampling passes = weighing(weights);
    const Interval permitted = accumulation_permitted(shown, passes, Accumulation::exact_mean);
    const double exact = accumulated(shown, passes, Accumulation::exact_mean);
    EXPECT_TRUE(permitted.contains(exact));
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
      const double reported = sum_in_mode(shown, passes, mode);
      EXPECT_TRUE(permitted.contains(reported)) << round << " " << mode;
      if (reported != static_cast<double>(static_cast<float>(exact))) ++off;
    }
  }
  EXPECT_GT(off, 3000);
}

// How far from the mean the ruling reaches, in another order of operations and without rounding.
TEST(Accumulation, Ruling36IsTheFormula) {
  const std::vector<double> shown = {0.75, -0.5, 3, 0x1p-30};
  const Supersampling passes = weighing({3, 1, 1000, 77});
  const long double roundings = 9 * 0x1p-23L;
  const auto reach = [&](long double magnitude, long double weights, long double divisor) {
    return roundings / (1 - roundings) * magnitude / divisor +
           0x1p-125L * (weights + 8 + divisor) / divisor;
  };
  const long double magnitude = 2.25L + 0.5L + 3000 + 77 * 0x1p-30L;
  const long double sum = magnitude - 1;
  for (const Accumulation choice :
       {Accumulation::exact_mean, Accumulation::float32_sum, Accumulation::sum}) {
    const long double divisor = choice == Accumulation::sum ? 1 : 1081;
    const Interval permitted = accumulation_permitted(shown, passes, choice);
    const long double margin = reach(magnitude, 1081, divisor);
    EXPECT_NEAR(static_cast<double>((permitted.high - sum / divisor) / margin), 1, 1e-6);
    EXPECT_NEAR(static_cast<double>((sum / divisor - permitted.low) / margin), 1, 1e-6);
  }
}

TEST(Accumulation, TinyNumbersMayBeFlushed) {
  const std::vector<double> shown = {0x1p-149, 0x1p-140};
  const Supersampling passes = weighing({1, 1});
  const Interval permitted = accumulation_permitted(shown, passes, Accumulation::exact_mean);
  EXPECT_TRUE(permitted.contains(0));
  EXPECT_FALSE(permitted.contains(0x1p-120));
}

TEST(Accumulation, NothingIsSaidOfWhatIsNotFinite) {
  const Supersampling passes = weighing({1, 3});
  for (const double odd : {kInfinity, -kInfinity, std::nan("")}) {
    const Interval permitted =
        accumulation_permitted(std::vector{odd, 1.0}, passes, Accumulation::exact_mean);
    EXPECT_EQ(permitted.low, -kInfinity);
    EXPECT_EQ(permitted.high, kInfinity);
  }
  // Three times this overflows.
  const std::vector<double> large = {1, 0x1p127};
  EXPECT_EQ(accumulation_permitted(large, passes, Accumulation::exact_mean).high, kInfinity);
  const std::vector<double> smaller = {1, 0x1p126};
  EXPECT_LT(accumulation_permitted(smaller, passes, Accumulation::exact_mean).high, 0x1p126);
}

// Of zeros nothing else is open: 2 m (W + 2 n + D) / D, in units of m.
TEST(Accumulation, WhatMayBeFlushedOfZeros) {
  const auto reach = [](std::size_t count, Accumulation choice) {
    const std::vector<std::int64_t> weights = {1, 3, 5};
    const Supersampling passes =
        weighing({weights.begin(), weights.begin() + static_cast<int>(count)});
    return accumulation_permitted(std::vector<double>(count), passes, choice).high / 0x1p-126;
  };
  EXPECT_NEAR(reach(2, Accumulation::exact_mean), 6, 1e-6);
  EXPECT_NEAR(reach(3, Accumulation::exact_mean), 48.0 / 9, 1e-6);
  EXPECT_NEAR(reach(2, Accumulation::sum), 18, 1e-6);
  EXPECT_NEAR(reach(2, Accumulation::unweighted), 8, 1e-6);
}

TEST(Accumulation, WhatMayOverflowIsOpen) {
  const double largest = static_cast<double>(std::numeric_limits<float>::max());
  const auto high = [](double value) {
    return accumulation_permitted(std::vector{value}, weighing({1}), Accumulation::exact_mean).high;
  };
  EXPECT_EQ(high(largest * (1 - 0x1p-23)), kInfinity);
  EXPECT_LT(high(largest * (1 - 0x1p-19)), kInfinity);
  // A sum that the largest number bounds does not overflow.
  const Interval roundings = 6 * 0x1p-23;
  const Interval growth = roundings / (Interval(1) - roundings);
  const auto bound = [&](double value) {
    const Interval magnitude = Interval() + Interval(1) * value;
    return (magnitude * (growth + 1)).high;
  };
  double value = largest * (1 - 6 * 0x1p-23) * (1 - 0x1p-40);
  while (bound(value) < largest) value = std::nextafter(value, kInfinity);
  ASSERT_EQ(bound(value), largest);
  EXPECT_LT(high(value), kInfinity);
  while (bound(value) == largest) value = std::nextafter(value, kInfinity);
  EXPECT_EQ(high(value), kInfinity);
}

TEST(Accumulation, OfWhatIsAlikeAndOfWhatIsNotFinite) {
  EXPECT_EQ(accumulated(std::vector<double>{2, 2}, weighing({1, 3}), Accumulation::sum), 8);
  EXPECT_EQ(accumulated(std::vector<double>{2, 2}, weighing({1, 3}), Accumulation::clamped), 1);
  // Weighted, the second one overflows as well.
  EXPECT_TRUE(std::isnan(accumulated(std::vector{kInfinity, -1e308}, weighing({1, 1048576}),
                                     Accumulation::exact_mean)));
}

}  // namespace
}  // namespace edgecase
