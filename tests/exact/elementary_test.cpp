// SPDX-License-Identifier: MIT
#include "exact/elementary.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "tests/support/share.h"

namespace edgecase {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_50;

// The distance to the true value, in units in the last place of the answer.
double units_off(double answer, const Wide& truth) {
  const double unit = std::ldexp(1, std::ilogb(answer) - 52);
  return static_cast<double>(abs(truth - Wide(answer)) / Wide(unit));
}

// The rounding to a double, half a unit, and a few units of a long double, 2^-11 of one each.
constexpr double kMost = 0.5 + 4.0 / 2048;

constexpr int kDraws = 20'000;

TEST(Elementary, DrawnAnswersAreOffByLittleMoreThanHalfAUnit) {
  std::mt19937_64 random(share_seed(7));
  const auto between = [&](double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(random() >> 11), -53);
  };
  for (int i = 0; i < share_of(kDraws); ++i) {
    const double angle = between(-7, 7);
    EXPECT_LE(units_off(cosine(angle), cos(Wide(angle))), kMost) << angle;
    EXPECT_LE(units_off(sine(angle), sin(Wide(angle))), kMost) << angle;
    const double power = between(-40, 40);
    EXPECT_LE(units_off(exponential(power), exp(Wide(power))), kMost) << power;
    EXPECT_LE(units_off(power_of_2(power), pow(Wide(2), Wide(power))), kMost) << power;
    const double value = std::exp2(between(-60, 60));
    EXPECT_LE(units_off(binary_logarithm(value), log(Wide(value)) / log(Wide(2))), kMost) << value;
    const double base = between(0.01, 1);
    EXPECT_LE(units_off(raised(base, 2.4), pow(Wide(base), Wide(2.4))), kMost) << base;
  }
}

TEST(Elementary, WhereTheAnswerIsANumberItIsThat) {
  EXPECT_EQ(cosine(0), 1);
  EXPECT_EQ(sine(0), 0);
  EXPECT_EQ(exponential(0), 1);
  EXPECT_EQ(raised(1.0, 2.4), 1);
  EXPECT_EQ(binary_logarithm(0), -std::numeric_limits<double>::infinity());
  for (int power = -60; power <= 60; ++power) {
    EXPECT_EQ(power_of_2(power), std::ldexp(1, power));
    EXPECT_EQ(binary_logarithm(std::ldexp(1, power)), power);
  }
}

}  // namespace
}  // namespace edgecase
