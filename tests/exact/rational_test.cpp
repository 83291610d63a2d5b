// SPDX-License-Identifier: MIT
#include "exact/rational.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace edgecase {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

Rational fraction(std::int64_t above, std::int64_t below) {
  return Rational(Integer(above), Integer(below));
}

double any_double(std::mt19937_64& random) {
  while (true) {
    const auto value = std::bit_cast<double>(random());
    if (std::isfinite(value)) return value;
  }
}

TEST(Rational, OfADoubleIsThatDouble) {
  EXPECT_EQ(rational_of(0.0), 0);
  EXPECT_EQ(rational_of(-0.0), 0);
  EXPECT_EQ(rational_of(1.0), 1);
  EXPECT_EQ(rational_of(-1.0), -1);
  EXPECT_EQ(rational_of(0.75), fraction(3, 4));
  EXPECT_EQ(rational_of(-2.5F), fraction(-5, 2));
  EXPECT_EQ(rational_of(0x1p60), Rational(Integer(1) << 60));
  std::mt19937_64 random(1);
  for (int i = 0; i < 20'000; ++i) {
    const double value = i == 0 ? kLargest : i == 1 ? kSmallest : any_double(random);
    const Rational exact = rational_of(value);
    // Digits after the point by hand: the number is a multiple of 2^-1074.
    int exponent = 0;
    const double digits = std::ldexp(std::frexp(value, &exponent), 53);
    ASSERT_EQ(exact * power_of_two(1200),
              Rational(Integer(static_cast<std::int64_t>(digits)) << (exponent - 53 + 1200)));
    const Interval back = interval_of(exact);
    ASSERT_EQ(back.low, value);
    ASSERT_EQ(back.high, value);
  }
}

TEST(Rational, OfAnInt128) {
  const Int128 large = (Int128{1} << 100) + 3;
  EXPECT_EQ(integer_of(large), (Integer(1) << 100) + 3);
  EXPECT_EQ(rational_of(Int128{-large}), -Rational((Integer(1) << 100) + 3));
}

TEST(Rational, QuotientsHaveEitherSign) {
  EXPECT_EQ(quotient_of(6, -4), fraction(-3, 2));
  EXPECT_EQ(quotient_of(-6, -4), fraction(3, 2));
  EXPECT_EQ(quotient_of(-6, 4), fraction(-3, 2));
  EXPECT_EQ(quotient_of(-6, -1), 6);
  EXPECT_EQ(quotient_of(6, -1), -6);
}

TEST(Rational, FloorIsBelowWhateverTheSign) {
  EXPECT_EQ(floor_of(fraction(7, 2)), 3);
  EXPECT_EQ(floor_of(fraction(-7, 2)), -4);
  EXPECT_EQ(floor_of(fraction(-8, 2)), -4);
  EXPECT_EQ(floor_of(Rational(0)), 0);
  EXPECT_TRUE(is_whole(fraction(-8, 2)));
  EXPECT_FALSE(is_whole(fraction(1, 3)));
}

TEST(Rational, PowersOfTwoOfEitherSign) {
  EXPECT_EQ(power_of_two(-2), fraction(1, 4));
  EXPECT_EQ(power_of_two(0), 1);
  EXPECT_EQ(power_of_two(70) * power_of_two(-69), 2);
}

// No narrower interval of doubles holds the number: its ends are neighbours, or one point.
void expect_narrowest(const Rational& value, const Interval& interval) {
  if (interval.low == interval.high) {
    ASSERT_EQ(rational_of(interval.low), value);
    return;
  }
  ASSERT_EQ(next_above(interval.low), interval.high);
  if (!std::isinf(interval.low)) {
    ASSERT_LT(rational_of(interval.low), value);
  }
  if (!std::isinf(interval.high)) {
    ASSERT_GT(rational_of(interval.high), value);
  }
}

TEST(Rational, IntervalsAreTheNarrowest) {
  EXPECT_EQ(interval_of(Rational(0)).low, 0);
  EXPECT_EQ(interval_of(Rational(0)).high, 0);
  std::mt19937_64 random(2);
  for (int i = 0; i < 20'000; ++i) {
    const auto above = static_cast<std::int64_t>(random() >> (random() % 63));
    const auto below = static_cast<std::int64_t>(random() >> (1 + random() % 62)) + 1;
    const Rational value = fraction(i % 2 == 0 ? above / 2 : -(above / 2), below);
    expect_narrowest(value, interval_of(value));
    const Rational far = value * power_of_two(static_cast<int>(random() % 2400) - 1200);
    expect_narrowest(far, interval_of(far));
  }
}

// As large as they may be, and their own multiples: what is not reduced is the same number.
TEST(MachineQuotient, HasTheIntervalOfTheRational) {
  std::mt19937_64 random(3);
  const auto drawn = [&](int digits) {
    const Int128 wide = (Int128{random() >> 1} << 64) + static_cast<Int128>(random());
    return wide >> (127 - 1 - static_cast<int>(random() % static_cast<unsigned>(digits)));
  };
  int exact = 0;
  for (int i = 0; i < 40'000; ++i) {
    MachineQuotient quotient{drawn(120), drawn(73) + 1};
    if (i % 4 == 0) quotient = {drawn(60) * quotient.below, quotient.below};
    if (i % 2 == 0) quotient.above = -quotient.above;
    if (!quotient.is_small()) continue;
    const Rational value = quotient_of(integer_of(quotient.above), integer_of(quotient.below));
    const Interval interval = interval_of(quotient);
    expect_narrowest(value, interval);
    if (HasFatalFailure()) FAIL() << i;
    exact += interval.low == interval.high;
  }
  EXPECT_GT(exact, 5000);
  EXPECT_FALSE((MachineQuotient{Int128{1} << 120, 1}.is_small()));
  EXPECT_FALSE((MachineQuotient{1, Int128{1} << 73}.is_small()));
}

TEST(Rational, IntervalsBesideDoublesAndBeyondThem) {
  const Rational tiny = power_of_two(-2000);
  for (const double value : {1.0, 0x1p-1022, kSmallest, 0x1.fffffffffffffp-1, -3.0}) {
    const Interval above = interval_of(Rational(rational_of(value) + tiny));
    EXPECT_EQ(above.low, value);
    EXPECT_EQ(above.high, next_above(value));
    const Interval below = interval_of(Rational(rational_of(value) - tiny));
    EXPECT_EQ(below.low, next_below(value));
    EXPECT_EQ(below.high, value);
  }
  EXPECT_EQ(interval_of(tiny).low, 0);
  EXPECT_EQ(interval_of(tiny).high, kSmallest);
  EXPECT_EQ(interval_of(Rational(-tiny)).low, -kSmallest);
  EXPECT_EQ(interval_of(power_of_two(5000)).low, kLargest);
  EXPECT_TRUE(std::isinf(interval_of(power_of_two(5000)).high));
  EXPECT_EQ(interval_of(Rational(-power_of_two(1024))).high, -kLargest);
}

}  // namespace
}  // namespace edgecase
