// SPDX-License-Identifier: MIT
//
// Levels of detail on and beside the borders between two answers.
#include "raster/texture_level.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

RationalFootprint footprint_of(std::array<Rational, 2> dx, std::array<Rational, 2> dy) {
  return {std::move(dx), std::move(dy), 2};
}

Interval lambda_of(const RationalFootprint& footprint, Log2Method log2 = Log2Method::exact) {
  return log2_of(scale_factor(intervals_of(footprint), ScaleFactor::lengths), log2);
}

bool is_point(Interval interval, double value) {
  return interval.low == value && interval.high == value;
}

TEST(TextureLevel, SquaresAreThoseOfEveryScaleFactor) {
  RandomNumbers numbers(1);
  const auto partial = [&] {
    return Rational(Integer(numbers.integer(-60, 60)), Integer(numbers.integer(1, 12)));
  };
  for (int i = 0; i < 3'000; ++i) {
    const RationalFootprint f = footprint_of({partial(), partial()}, {partial(), partial()});
    for (const ScaleFactor method : values_of<ScaleFactor>()) {
      const Interval root = scale_factor(intervals_of(f), method);
      const Rational squared = squared_scale_factor(f, method);
      ASSERT_LE(rational_of(root.low) * rational_of(root.low), squared) << name_of(method);
      ASSERT_GE(rational_of(root.high) * rational_of(root.high), squared) << name_of(method);
    }
  }
}

TEST(TextureLevel, FootprintsAreInTexelsOfTheBase) {
  const Rational third(1, 3);
  EXPECT_EQ(RationalFootprint{}.dimensions, 2);
  const RationalFootprint f = in_texels(footprint_of({third, 2}, {0, -third}), 6, 9);
  EXPECT_EQ(f.dx, (std::array<Rational, 2>{2, 18}));
  EXPECT_EQ(f.dy, (std::array<Rational, 2>{0, -3}));
  const Footprint intervals = intervals_of(f);
  EXPECT_TRUE(is_point(intervals.dx[1], 18));
  EXPECT_TRUE(is_point(intervals.dy[1], -3));
}

// (1, 1): the root of 2, of which no double is the logarithm's argument, is half a level exactly.
TEST(TextureLevel, RootsOfPowersOfTwoAreTies) {
  for (int exponent = -20; exponent <= 20; ++exponent) {
    const Rational side = power_of_two(exponent);
    const RationalFootprint f = footprint_of({side, side}, {0, 0});
    const Rational squared = squared_scale_factor(f, ScaleFactor::lengths);
    EXPECT_TRUE(is_level_open(lambda_of(f), LevelWeight::exact));
    const Interval decided =
        decided_level(lambda_of(f), squared, 0, Log2Method::exact, LevelWeight::exact);
    EXPECT_TRUE(is_point(decided, exponent + 0.5));
  }
}

// Off the tie by less than doubles know: strictly on either side, and close.
TEST(TextureLevel, BesideATieIsOnItsSide) {
  for (const int sign : {-1, 1}) {
    const Rational side = 1 + sign * power_of_two(-90);
    const RationalFootprint f = footprint_of({side, side}, {0, 0});
    const Interval decided =
        decided_level(lambda_of(f), squared_scale_factor(f, ScaleFactor::lengths), 0,
                      Log2Method::exact, LevelWeight::exact);
    EXPECT_EQ(decided.high < 0.5, sign < 0);
    EXPECT_EQ(decided.low > 0.5, sign > 0);
    EXPECT_NEAR(decided.low, 0.5, 1e-14);
    EXPECT_NEAR(decided.high, 0.5, 1e-14);
  }
}

TEST(TextureLevel, TiesMoveWithTheBias) {
  const RationalFootprint f = footprint_of({1, 1}, {0, 0});
  const auto decided = [&](double bias, LevelWeight weight) {
    const Interval prime = lambda_of(f) + Interval(bias);
    return decided_level(prime, 2, bias, Log2Method::exact, weight);
  };
  EXPECT_TRUE(is_point(decided(1.5, LevelWeight::exact), 2));
  EXPECT_TRUE(is_point(decided(-2, LevelWeight::exact), -1.5));
  // 1/2 + 3/256 is a border of weights of 8 bits alone.
  EXPECT_TRUE(is_point(decided(3.0 / 256, LevelWeight::floor_8), 0.5 + 3.0 / 256));
  EXPECT_LT(decided(3.0 / 256, LevelWeight::exact).low, 0.5 + 3.0 / 256);
  EXPECT_FALSE(is_level_open(Interval(0.51, 0.52), LevelWeight::narrow));
  EXPECT_TRUE(is_level_open(Interval(0.51, 0.52), LevelWeight::nearest_8));
}

// 3 texels and a bias of 1.415...: the sum is near 3, and never is.
TEST(TextureLevel, IrrationalSumsAreNoTies) {
  const double bias = 3 - std::log2(3.0);
  const Interval prime = lambda_of(footprint_of({3, 0}, {0, 0})) + Interval(bias);
  ASSERT_TRUE(is_level_open(prime, LevelWeight::exact));
  const Interval decided = decided_level(prime, 9, bias, Log2Method::exact, LevelWeight::exact);
  EXPECT_TRUE(decided.low > 3 || decided.high < 3);
}

// Of 3/2 the linear mantissa is 1/2, and of 3 it is 3/2; the scale factor is the root of a square
// that no double holds.
TEST(TextureLevel, LinearMantissasHaveTiesOfTheirOwn) {
  for (const int scale : {1, 2, 8}) {
    // (0.9 s, 1.2 s) is as long as 1.5 s.
    const RationalFootprint f =
        footprint_of({Rational(9 * scale, 10), Rational(12 * scale, 10)}, {0, 0});
    const Rational squared = squared_scale_factor(f, ScaleFactor::lengths);
    const Interval decided = decided_level(lambda_of(f, Log2Method::linear_mantissa), squared, 0,
                                           Log2Method::linear_mantissa, LevelWeight::exact);
    EXPECT_TRUE(is_point(decided, std::log2(scale) + 0.5));
    const Interval above =
        decided_level(lambda_of(f, Log2Method::linear_mantissa), squared + power_of_two(-90), 0,
                      Log2Method::linear_mantissa, LevelWeight::exact);
    EXPECT_GT(above.low, std::log2(scale) + 0.5);
  }
}

TEST(TextureLevel, WhatTouchesNothingStays) {
  const Interval prime(0.6, 0.7);
  const Interval decided = decided_level(prime, 3, 0, Log2Method::exact, LevelWeight::exact);
  EXPECT_EQ(decided.low, prime.low);
  EXPECT_EQ(decided.high, prime.high);
  EXPECT_FALSE(is_level_open(Interval::everything(), LevelWeight::exact));
}

// Half of what linear-mantissa makes of the square: of 5/4 it is 1/8.
TEST(TextureLevel, LinearMantissasOfSquaresHaveTies) {
  const Log2Method method = Log2Method::linear_mantissa_of_square;
  for (int exponent = -3; exponent <= 3; ++exponent) {
    const Rational side = power_of_two(exponent);
    const RationalFootprint f = footprint_of({side, side / 2}, {0, 0});
    const Rational squared = side * side * 5 / 4;
    const double level = exponent + 0.125;
    const auto decided = [&](const Rational& of, double bias, LevelWeight weight) {
      return decided_level(lambda_of(f, method) + Interval(bias), of, bias, method, weight);
    };
    EXPECT_TRUE(is_point(decided(squared, 0, LevelWeight::nearest_8), level));
    EXPECT_TRUE(is_point(decided(squared, 0.375, LevelWeight::exact), exponent + 0.5));
    EXPECT_GT(decided(squared + power_of_two(-90), 0, LevelWeight::nearest_8).low, level);
    EXPECT_LT(decided(squared - power_of_two(-90), 0, LevelWeight::nearest_8).high, level);
  }
}

// Where a border is irrational the larger part of the interval is taken, and all of it that there
// is.
TEST(TextureLevel, TheMiddleTellsTheSideOfIrrationalBorders) {
  const double bias = 3 - std::log2(3.0);
  const double below = next_below(3), above = next_above(3);
  const auto decided = [&](double low, double high) {
    const Interval found =
        decided_level({low, high}, 9, bias, Log2Method::exact, LevelWeight::exact);
    return std::pair{found.low, found.high};
  };
  using Ends = std::pair<double, double>;
  EXPECT_EQ(decided(below, 3 + 0x1p-40), Ends(above, 3 + 0x1p-40));
  EXPECT_EQ(decided(3 - 0x1p-40, above), Ends(3 - 0x1p-40, below));
  EXPECT_EQ(decided(3 - 0x1p-40, 3 + 0x1p-40), Ends(above, 3 + 0x1p-40));
  // Up to the border itself, or from it on.
  EXPECT_EQ(decided(3 - 0x1p-40, 3), Ends(3 - 0x1p-40, below));
  EXPECT_EQ(decided(3, 3 + 0x1p-40), Ends(above, 3 + 0x1p-40));
}

// An end on a border touches it; endless intervals have no side to decide.
TEST(TextureLevel, EndsTouchBordersUnlessThereIsNone) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(is_level_open({0.4, 0.5}, LevelWeight::exact));
  EXPECT_TRUE(is_level_open({0.5, 0.6}, LevelWeight::exact));
  EXPECT_FALSE(is_level_open({0.4, next_below(0.5)}, LevelWeight::exact));
  EXPECT_FALSE(is_level_open({-infinity, 3}, LevelWeight::exact));
  EXPECT_FALSE(is_level_open({3.2, infinity}, LevelWeight::exact));
  const Interval tiny = decided_level({-infinity, -1074}, power_of_two(-2400), 0, Log2Method::exact,
                                      LevelWeight::exact);
  EXPECT_EQ(tiny.low, -infinity);
  EXPECT_EQ(tiny.high, -1074);
}

// Vectors whose lengths are roots, one a whole multiple of the other: as many probes as that.
TEST(TextureLevel, WholeQuotientsOfLengthsAreWhole) {
  Sampler sampler;
  sampler.max_anisotropy = 16;
  const TextureChoice choice;
  RandomNumbers numbers(2);
  int counted = 0;
  for (int i = 0; i < 3'000; ++i) {
    const Rational a(Integer(numbers.integer(-50, 50)), Integer(numbers.integer(1, 9)));
    const Rational b(Integer(numbers.integer(1, 50)), Integer(numbers.integer(1, 9)));
    const auto times = static_cast<int>(numbers.integer(2, 15));
    const RationalFootprint f = footprint_of({a * times, b * times}, {-b, a});
    const ProbeRow row = exact_probes(f, sampler, choice);
    ASSERT_EQ(row.probes.size(), static_cast<std::size_t>(times));
    ASSERT_TRUE(row.along_x);
    // The level is that of the shorter vector.
    const Rational squared = squared_scale_factor(f, row, sampler, choice);
    ASSERT_EQ(squared, a * a + b * b);
    ASSERT_LE(rational_of(row.scale_factor.low) * rational_of(row.scale_factor.low), squared);
    ASSERT_GE(rational_of(row.scale_factor.high) * rational_of(row.scale_factor.high), squared);
    // A little longer than that: one more.
    if (times == 15) continue;
    const Rational more = times * (1 + power_of_two(-40));
    const RationalFootprint longer = footprint_of({a * more, b * more}, {-b, a});
    ASSERT_EQ(exact_probes(longer, sampler, choice).probes.size(),
              static_cast<std::size_t>(times + 1));
    ++counted;
  }
  EXPECT_GT(counted, 1'000);
}

// Two vectors of one length, turned against each other, whose rounded lengths may differ.
TEST(TextureLevel, EqualLengthsHaveOneProbe) {
  Sampler sampler;
  sampler.max_anisotropy = 16;
  const TextureChoice choice;
  RandomNumbers numbers(3);
  int rounded_apart = 0;
  for (int i = 0; i < 1'000; ++i) {
    const Rational a(Integer(numbers.integer(-50, 50)), Integer(numbers.integer(1, 9)));
    const Rational b(Integer(numbers.integer(1, 50)), Integer(numbers.integer(1, 9)));
    const RationalFootprint f = footprint_of({a, b}, {(3 * a - 4 * b) / 5, (4 * a + 3 * b) / 5});
    const ProbeRow row = exact_probes(f, sampler, choice);
    ASSERT_EQ(row.probes.size(), 1U);
    EXPECT_EQ(row.probes[0].offset, 0);
    const Rational squared = squared_scale_factor(f, row, sampler, choice);
    ASSERT_EQ(squared, a * a + b * b);
    ASSERT_LE(rational_of(row.scale_factor.low) * rational_of(row.scale_factor.low), squared);
    ASSERT_GE(rational_of(row.scale_factor.high) * rational_of(row.scale_factor.high), squared);
    const ProbeRow of_intervals =
        probes(intervals_of(f), sampler.max_anisotropy, choice.anisotropy, choice.scale_factor);
    if (of_intervals.probes.size() > 1) ++rounded_apart;
  }
  EXPECT_GT(rounded_apart, 50);
}

TEST(TextureLevel, ProbesLieWhereTheFormulasSay) {
  Sampler sampler;
  sampler.max_anisotropy = 4;
  TextureChoice choice;
  const RationalFootprint f = footprint_of({0, 0}, {3, -6});
  ProbeRow row = exact_probes(f, sampler, choice);
  auto ways = ways_to(row, f, choice.anisotropy);
  ASSERT_EQ(ways.size(), 4U);
  for (int i = 1; i <= 4; ++i)
    EXPECT_EQ(ways[static_cast<std::size_t>(i - 1)][0], 3 * (Rational(i, 5) - Rational(1, 2)));
  EXPECT_EQ(squared_scale_factor(f, row, sampler, choice), Rational(45, 16));
  choice.anisotropy = Anisotropy::gaussian_5;
  row = exact_probes(f, sampler, choice);
  ways = ways_to(row, f, choice.anisotropy);
  ASSERT_EQ(ways.size(), 5U);
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(ways[static_cast<std::size_t>(i)][1], -6 * Rational(i - 2, 5));
  EXPECT_EQ(squared_scale_factor(f, row, sampler, choice), Rational(45, 25));
  for (const float most : {1.0F, 1.5F, 2.0F}) {
    sampler.max_anisotropy = most;
    EXPECT_EQ(is_anisotropic(sampler, choice), most > 1) << most;
  }
  choice.anisotropy = Anisotropy::none;
  EXPECT_FALSE(is_anisotropic(sampler, choice));
  EXPECT_EQ(squared_scale_factor(f, exact_probes(f, sampler, choice), sampler, choice), 45);
}

// s grows along x, or t along y, or nothing does.
TEST(TextureLevel, WhatStandsStillHasNoExtent) {
  const auto has_none = [](std::array<Interval, 3> s, std::array<Interval, 3> t, int dimensions,
                           ScaleFactor method, double side = 16) {
    const auto of = [&](const std::array<Interval, 3>& values) {
      return Interpolant{PrimitiveKind::triangle,
                         {vertex_at(0, 0), vertex_at(side, 0), vertex_at(0, side)},
                         values};
    };
    TextureChoice choice;
    choice.scale_factor = method;
    return has_no_extent({of(s), of(t)}, in_quad({3, 3}, RowOrder::bottom_up, 16), dimensions,
                         choice);
  };
  const std::array<Interval, 3> still{0.5, 0.5, 0.5}, along_x{0, 1, 0}, along_y{0, 0, 1};
  EXPECT_TRUE(has_none(still, still, 2, ScaleFactor::lengths));
  EXPECT_FALSE(has_none(along_x, still, 2, ScaleFactor::lengths));
  EXPECT_FALSE(has_none(along_y, still, 2, ScaleFactor::lengths));
  EXPECT_FALSE(has_none(still, along_x, 2, ScaleFactor::lengths));
  EXPECT_FALSE(has_none(still, along_y, 2, ScaleFactor::lengths));
  // Of one dimension, t is no matter.
  EXPECT_TRUE(has_none(still, along_y, 1, ScaleFactor::lengths));
  EXPECT_FALSE(has_none(along_x, along_y, 1, ScaleFactor::lengths));
  EXPECT_TRUE(has_none(along_y, along_y, 2, ScaleFactor::x_only));
  EXPECT_FALSE(has_none(along_x, along_y, 2, ScaleFactor::x_only));
  EXPECT_TRUE(has_none(along_x, along_x, 2, ScaleFactor::y_only));
  EXPECT_FALSE(has_none(along_x, along_y, 2, ScaleFactor::y_only));
  // Nothing is known of a triangle without an area.
  EXPECT_FALSE(has_none(along_x, along_y, 2, ScaleFactor::lengths, 0));
}

}  // namespace
}  // namespace edgecase
