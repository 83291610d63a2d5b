// SPDX-License-Identifier: MIT
//
// Every operation must hold the true result of every pair of members. The truth is computed in
// 113-bit floating point, which is exact for sums and products of doubles of like size and has an
// error far below a double's for quotients.
#include "exact/interval.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace edgecase {
namespace {

__extension__ using Wide = __float128;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool holds(Interval interval, Wide truth) {
  return static_cast<Wide>(interval.low) <= truth && truth <= static_cast<Wide>(interval.high);
}

bool is_everything(Interval interval) {
  return interval.low == -kInfinity && interval.high == kInfinity;
}

class RandomIntervals : public ::testing::Test {
 protected:
  // Magnitudes from 2^-40 to 2^40; sometimes a point, sometimes a whole number.
  double number() {
    const double mantissa = std::uniform_real_distribution<double>(-1, 1)(engine_);
    const int exponent = std::uniform_int_distribution<int>(-40, 40)(engine_);
    const double value = std::ldexp(mantissa, exponent);
    return engine_() % 4 == 0 ? std::floor(value) : value;
  }
  Interval interval() {
    const double a = number();
    const double b = engine_() % 4 == 0 ? a : number();
    return {std::min(a, b), std::max(a, b)};
  }
  // The ends and a member between them.
  std::array<double, 3> members(Interval of) {
    const double between =
        of.low + (of.high - of.low) * std::uniform_real_distribution<>(0, 1)(engine_);
    return {of.low, of.high, std::clamp(between, of.low, of.high)};
  }
  template <class Operation, class Truth>
  void expect_enclosed(Operation operation, Truth truth) {
    for (int i = 0; i < 50000; ++i) {
      const Interval a = interval(), b = interval();
      const Interval result = operation(a, b);
      for (double x : members(a))
        for (double y : members(b))
          ASSERT_TRUE(holds(result, truth(static_cast<Wide>(x), static_cast<Wide>(y))))
              << "[" << a.low << ", " << a.high << "] and [" << b.low << ", " << b.high << "]";
    }
  }
  std::mt19937_64 engine_{7};
};

TEST_F(RandomIntervals, SumsAreEnclosed) {
  expect_enclosed([](Interval a, Interval b) { return a + b; },
                  [](Wide x, Wide y) { return x + y; });
}

TEST_F(RandomIntervals, DifferencesAreEnclosed) {
  expect_enclosed([](Interval a, Interval b) { return a - b; },
                  [](Wide x, Wide y) { return x - y; });
}

TEST_F(RandomIntervals, ProductsAreEnclosed) {
  expect_enclosed([](Interval a, Interval b) { return a * b; },
                  [](Wide x, Wide y) { return x * y; });
}

TEST_F(RandomIntervals, QuotientsAreEnclosed) {
  int divided = 0;
  for (int i = 0; i < 50000; ++i) {
    const Interval a = interval(), b = interval();
    const Interval result = a / b;
    if (b.contains(0)) {
      ASSERT_TRUE(is_everything(result));
      continue;
    }
    ++divided;
    for (double x : members(a))
      for (double y : members(b))
        ASSERT_TRUE(holds(result, static_cast<Wide>(x) / static_cast<Wide>(y))) << x << " / " << y;
  }
  EXPECT_GT(divided, 10000);
}

TEST_F(RandomIntervals, WidenedHoldsEveryErrorOfThatSize) {
  for (int i = 0; i < 50000; ++i) {
    const Interval a = interval();
    const double relative = std::uniform_real_distribution<double>(0, 2)(engine_);
    const Interval result = widened(a, relative);
    const Wide margin = static_cast<Wide>(a.magnitude()) * static_cast<Wide>(relative);
    ASSERT_TRUE(holds(result, static_cast<Wide>(a.low) - margin)) << a.low << " " << a.high;
    ASSERT_TRUE(holds(result, static_cast<Wide>(a.high) + margin)) << a.low << " " << a.high;
    // Not much wider than asked for.
    ASSERT_LE(result.high - result.low, (a.high - a.low) + 2.001 * a.magnitude() * relative +
                                            8 * a.magnitude() * 0x1p-52 + 0x1p-1000);
  }
}

// The margin is of the size of the lower end, and all but one bit cancels.
TEST(Interval, WidenedHoldsItsEndsUnderCancellation) {
  std::mt19937_64 engine(3);
  for (int i = 0; i < 50000; ++i) {
    const double high = std::uniform_real_distribution<double>(1, 2)(engine);
    const double relative = 1e-5;
    const Interval a{high * relative, high};
    ASSERT_TRUE(
        holds(widened(a, relative),
              static_cast<Wide>(a.low) - static_cast<Wide>(high) * static_cast<Wide>(relative)));
  }
}

TEST_F(RandomIntervals, HullIsTheSmallestThatHoldsBoth) {
  for (int i = 0; i < 10000; ++i) {
    const Interval a = interval(), b = interval(), both = hull(a, b);
    ASSERT_EQ(both.low, std::min(a.low, b.low));
    ASSERT_EQ(both.high, std::max(a.high, b.high));
  }
}

TEST(Interval, DivisionByAnIntervalWithZeroKnowsNothing) {
  for (Interval zero :
       {Interval(0), Interval(-0.0), Interval(0, 1), Interval(-1, 0), Interval(-1, 1)})
    EXPECT_TRUE(is_everything(Interval(1, 2) / zero));
}

TEST(Interval, WhatIsUnknownStaysUnknown) {
  const Interval all = Interval::everything();
  for (Interval result : {all + Interval(1), all - all, all * Interval(0), all / all,
                          widened(all, 0), hull(all, Interval(2))})
    EXPECT_TRUE(is_everything(result));
}

TEST(Interval, WhatOneEndDoesNotKnowNeitherDoesTheOther) {
  // Minus and plus infinity make no number, at one end or at the other.
  EXPECT_TRUE(is_everything(Interval(-kInfinity, 0) + Interval(kInfinity)));
  EXPECT_TRUE(is_everything(Interval(0, kInfinity) + Interval(-kInfinity)));
}

TEST(Interval, ProductOfZeroAndInfinityKnowsNothingAtAnyEnd) {
  const Interval below(-1, 0), above(0, 1);
  for (Interval result : {above * Interval(-kInfinity, 1), above * Interval(1, kInfinity),
                          below * Interval(-kInfinity, 1), below * Interval(1, kInfinity)})
    EXPECT_TRUE(is_everything(result));
}

TEST(Interval, OfAnIntegerIsAPointWhereDoubleHoldsIt) {
  const Int128 limit = Int128{1} << 53;
  for (Int128 value : {Int128{0}, Int128{-3}, limit - 1, limit, -limit}) {
    const Interval point = interval_of(value);
    EXPECT_EQ(point.low, static_cast<double>(value));
    EXPECT_EQ(point.high, static_cast<double>(value));
  }
  for (Int128 value : {limit + 1, -limit - 1, (Int128{1} << 100) + 1, 3 * (Int128{1} << 90) - 1}) {
    const Interval around = interval_of(value);
    EXPECT_TRUE(holds(around, static_cast<Wide>(value)));
    EXPECT_LT(around.low, around.high);
    EXPECT_LE(around.high - around.low, std::ldexp(around.magnitude(), -51));
  }
}

TEST(Interval, OverflowAndUnderflowStayEnclosed) {
  const double largest = std::numeric_limits<double>::max();
  const Interval sum = Interval(largest) + Interval(largest);
  EXPECT_TRUE(sum.low <= largest && sum.high == kInfinity);
  const Interval tiny = Interval(0x1p-600) * Interval(0x1p-600);
  EXPECT_TRUE(tiny.low <= 0 && tiny.high > 0);
}

TEST(Interval, ContainsItsEndsAndNoNaN) {
  const Interval interval(-1, 2);
  EXPECT_TRUE(interval.contains(-1) && interval.contains(2) && interval.contains(0));
  EXPECT_FALSE(interval.contains(-1.0000001) || interval.contains(2.0000001));
  EXPECT_FALSE(Interval::everything().contains(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(interval.magnitude(), 2);
  EXPECT_EQ(Interval(-3, 2).magnitude(), 3);
}

}  // namespace
}  // namespace edgecase
