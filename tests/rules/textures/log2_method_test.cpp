// SPDX-License-Identifier: MIT
//
// Logarithms, against one that is made digit by digit from squares alone.
#include "rules/textures/level_of_detail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Binary digits of the logarithm: squaring a number doubles its logarithm, and where it reaches 2
// the next digit is 1. Each step doubles the error, 2^-113 at first; 58 digits leave it below 2^-54
// of the last.
Wide literal_log2(Wide value) {
  Wide result = 0;
  for (; value >= 2; value /= 2) result += 1;
  for (; value < 1; value *= 2) result -= 1;
  Wide digit = 1;
  for (int i = 0; i < 58; ++i) {
    value *= value;
    digit /= 2;
    if (value < 2) continue;
    value /= 2;
    result += digit;
  }
  return result;
}
constexpr double kLiteralError = 0x1p-57;

Wide literal_linear_mantissa(Wide value) {
  Wide exponent = 0;
  for (; value >= 2; value /= 2) exponent += 1;
  for (; value < 1; value *= 2) exponent -= 1;
  return exponent + value - 1;
}

// The definitions, word by word.
Wide literal(double value, Log2Method method) {
  const auto x = static_cast<Wide>(value);
  switch (method) {
    case Log2Method::exact:
      return literal_log2(x);
    case Log2Method::linear_mantissa:
      return literal_linear_mantissa(x);
    case Log2Method::linear_mantissa_of_square:
      return literal_linear_mantissa(x * x) / 2;
    case Log2Method::linear_mantissa_of_fourth_power:
      return literal_linear_mantissa(x * x * x * x) / 4;
    case Log2Method::mantissa_8: {
      double power = 1;
      while (power * 2 <= value) power *= 2;
      while (power > value) power /= 2;
      const double steps = std::floor((value / power - 1) * 256 + 0.5);
      return literal_log2(static_cast<Wide>(power) * static_cast<Wide>(1 + steps / 256));
    }
  }
  return 0;
}

// How far beyond its bounds a number lies.
double beyond(Interval bounds, Wide value) {
  const auto low = static_cast<double>(static_cast<Wide>(bounds.low) - value);
  const auto high = static_cast<double>(value - static_cast<Wide>(bounds.high));
  return std::max({low, high, 0.0});
}

TEST(Log2, HoldsTheLiteralNumberAndLittleElse) {
  RandomNumbers random(1);
  for (int i = 0; i < 20'000; ++i) {
    const double value = std::exp2(random.real(-12, 12));
    for (const Log2Method method : values_of<Log2Method>()) {
      const Interval result = log2_of(value, method);
      const Wide expected = literal(value, method);
      ASSERT_LE(beyond(result, expected), kLiteralError) << value << " " << name_of(method);
      ASSERT_LE(width_of(result), 0x1p-46) << value << " " << name_of(method);
    }
  }
}

// log2(1 + d) for tiny d, by its series; ln(2) as the sum of two doubles.
TEST(Log2, HoldsTheLogarithmBesideOne) {
  const Wide ln2 =
      static_cast<Wide>(0x1.62e42fefa39efp-1) + static_cast<Wide>(0x1.abc9e3b39803fp-56);
  for (int k = -50; k <= 50; ++k) {
    const double value = 1 + k * 0x1p-52;
    const Wide d = static_cast<Wide>(value) - 1;
    const Wide expected = (d - d * d / 2 + d * d * d / 3) / ln2;
    const Interval result = log2_of(value, Log2Method::exact);
    EXPECT_TRUE(holds(result, expected)) << k;
    EXPECT_LE(width_of(result), std::fabs(result.low) * 0x1p-48) << k;
  }
}

TEST(Log2, PowersOfTwoAreExact) {
  for (const Log2Method method : values_of<Log2Method>())
    for (int k = -200; k <= 200; ++k) {
      const Interval result = log2_of(std::ldexp(1, k), method);
      EXPECT_EQ(result.low, k) << name_of(method);
      EXPECT_EQ(result.high, k) << name_of(method);
    }
}

// Next to a power of two, the bounds do not reach across it: floor() and comparisons are sure.
TEST(Log2, BoundsStayBetweenWholeNumbers) {
  for (int k = -40; k <= 40; ++k) {
    const double power = std::ldexp(1, k);
    EXPECT_GE(log2_of(next_above(power), Log2Method::exact).low, k);
    EXPECT_LE(log2_of(next_below(power), Log2Method::exact).high, k);
  }
}

TEST(Log2, BoundsAreFourDoublesBesideTheLibrarys) {
  double low = std::log2(3.0);
  double high = low;
  for (int i = 0; i < 4; ++i) {
    low = next_below(low);
    high = next_above(high);
  }
  EXPECT_EQ(log2_of(3, Log2Method::exact).low, low);
  EXPECT_EQ(log2_of(3, Log2Method::exact).high, high);
}

TEST(Log2, GrowsWithItsArgument) {
  for (const Log2Method method : values_of<Log2Method>()) {
    Interval before = log2_of(0x1p-3, method);
    for (double value = 0x1p-3; value < 16; value += 0x1p-9) {
      const Interval now = log2_of(value, method);
      ASSERT_GE(now.low, before.low) << value << " " << name_of(method);
      ASSERT_GE(now.high, before.high) << value << " " << name_of(method);
      before = now;
    }
  }
}

TEST(Log2, OfAnIntervalIsThatOfItsEnds) {
  for (const Log2Method method : values_of<Log2Method>()) {
    const Interval result = log2_of({1.3, 5.7}, method);
    EXPECT_EQ(result.low, log2_of(1.3, method).low);
    EXPECT_EQ(result.high, log2_of(5.7, method).high);
  }
}

TEST(Log2, IsDefinedForEverything) {
  for (const Log2Method method : values_of<Log2Method>()) {
    EXPECT_EQ(log2_of(0, method).low, -kInfinity);
    EXPECT_EQ(log2_of(0, method).high, -kInfinity);
    EXPECT_EQ(log2_of(-1, method).high, -kInfinity);
    EXPECT_EQ(log2_of(kInfinity, method).low, kInfinity);
    EXPECT_EQ(log2_of(kInfinity, method).high, kInfinity);
    EXPECT_TRUE(is_everything(log2_of(kNone, method)));
    EXPECT_EQ(log2_of({0, 4}, method).low, -kInfinity);
    EXPECT_EQ(log2_of({0, 4}, method).high, 2);
    for (const double value : {0x1p-1074, 0x1p-600, 0x1p600, 0x1.fffffffffffffp1023}) {
      const Interval result = log2_of(value, method);
      EXPECT_LE(result.low, std::log2(value)) << name_of(method);
      EXPECT_GE(result.high, std::floor(std::log2(value) - 0.1)) << name_of(method);
    }
  }
}

// The errors that the meanings state, and no smaller ones.
TEST(Log2, ErrorsAreWhatTheCatalogueSays) {
  struct Error {
    Log2Method method;
    double least, most;
  };
  const Error errors[] = {{Log2Method::linear_mantissa, -0.08608, 0},
                          {Log2Method::linear_mantissa_of_square, -0.04304, 0},
                          {Log2Method::linear_mantissa_of_fourth_power, -0.02152, 0},
                          {Log2Method::mantissa_8, -0.00282, 0.00282}};
  for (const Error& error : errors) {
    double least = 0, most = 0;
    for (double value = 1; value < 2; value += 0x1p-18) {
      const double off = log2_of(value, error.method).low - std::log2(value);
      least = std::min(least, off);
      most = std::max(most, off);
    }
    EXPECT_NEAR(least, error.least, 2e-5) << name_of(error.method);
    EXPECT_NEAR(most, error.most, 2e-5) << name_of(error.method);
  }
}

TEST(Log2, OneNumberTellsEveryMethodApart) {
  std::set<double> results;
  for (const Log2Method method : values_of<Log2Method>())
    results.insert(log2_of(1.301, method).low);
  EXPECT_EQ(results.size(), values_of<Log2Method>().size());
}

TEST(Log2, OneMethodIsFartherOffThanAnyRendererMayBe) {
  // By rulings 20 and 50.
  for (const Alternative& alternative : log2_rule().alternatives)
    EXPECT_EQ(alternative.openness == Openness::illegal, alternative.name == "linear-mantissa")
        << alternative.name;
}

// What renderers tell of a level of detail is a float32 of these formulas. Measured with
// textureQueryLod on footprints along the axes: llvmpipe, SwiftShader and softpipe, Mesa 22.3.6.
TEST(Log2, IsWhatRenderersMeasureTo) {
  struct Measured {
    Log2Method method;
    double scale_factor, lambda;
  };
  const Measured rows[] = {
      {Log2Method::linear_mantissa_of_square, 0x1.f79d3ap+1, 0x1.f7aed0p+0},
      {Log2Method::linear_mantissa_of_square, 0x1.24ac64p+4, 0x1.09d338p+2},
      {Log2Method::linear_mantissa_of_square, 0x1.a2df34p+2, 0x1.55abb4p+1},
      {Log2Method::linear_mantissa_of_square, 0x1.21e7d6p+0, 0x1.213510p-3},
      {Log2Method::linear_mantissa_of_square, 0x1.73d24ap+7, 0x1.e1c0b4p+2},
      {Log2Method::linear_mantissa_of_square, 0x1.76ee58p+7, 0x1.e251d4p+2},
      {Log2Method::linear_mantissa_of_fourth_power, 0x1.f79d3ap+1, 0x1.f7d180p+0},
      {Log2Method::linear_mantissa_of_fourth_power, 0x1.24ac64p+4, 0x1.0b5550p+2},
      {Log2Method::linear_mantissa_of_fourth_power, 0x1.a2df34p+2, 0x1.595700p+1},
      {Log2Method::linear_mantissa_of_fourth_power, 0x1.21e7d6p+0, 0x1.4a0c00p-3},
      {Log2Method::linear_mantissa_of_fourth_power, 0x1.73d24ap+7, 0x1.e1cd00p+2},
      {Log2Method::linear_mantissa_of_fourth_power, 0x1.76ee58p+7, 0x1.e26760p+2},
      {Log2Method::mantissa_8, 0x1.f79d3ap+1, 0x1.fa2f04p+0},
      {Log2Method::mantissa_8, 0x1.24ac64p+4, 0x1.0c76e6p+2},
      {Log2Method::mantissa_8, 0x1.a2df34p+2, 0x1.5afbb4p+1},
      {Log2Method::mantissa_8, 0x1.21e7d6p+0, 0x1.70742ep-3},
      {Log2Method::mantissa_8, 0x1.73d24ap+7, 0x1.e28194p+2},
      {Log2Method::mantissa_8, 0x1.76ee58p+7, 0x1.e33f70p+2}};
  for (const Measured& row : rows)
    EXPECT_LE(beyond(log2_of(row.scale_factor, row.method), static_cast<Wide>(row.lambda)), 2e-6)
        << name_of(row.method) << " " << row.scale_factor;
}

}  // namespace
}  // namespace edgecase
