// SPDX-License-Identifier: MIT
//
// What exact answers, rounded to float32, is the float32 number nearest to the value, and between
// two that are as near the one whose last bit is 0: held against comparisons of quotients.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "raster/attributes.h"
#include "rules/values/rational_interpolation.h"
#include "tests/rules/values/interpolants.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

Rational distance(const Rational& a, const Rational& b) {
  return a < b ? Rational(b - a) : Rational(a - b);
}

bool is_correctly_rounded(float reported, const Rational& value) {
  const Rational error = distance(rational_of(reported), value);
  for (const float end : {-HUGE_VALF, HUGE_VALF}) {
    const Rational of_other = distance(rational_of(std::nextafterf(reported, end)), value);
    const bool is_even = (std::bit_cast<std::uint32_t>(reported) & 1) == 0;
    if (of_other < error || (of_other == error && !is_even)) return false;
  }
  return true;
}

float value_of(const Interpolant& f, Point sample) {
  return static_cast<float>(middle(interpolate_exact(f, sample)));
}

// Values that nearly cancel: the interval is wide beside what is left of them.
TEST(CorrectRounding, OfValuesThatCancel) {
  RandomNumbers random(share_seed(9));
  int wide = 0;
  for (int trial = 0; trial < share_of(4000); ++trial) {
    Interpolant f;
    f.kind = random.one_in(3) ? PrimitiveKind::line : PrimitiveKind::triangle;
    for (HomogeneousPoint& p : f.positions) p = homogeneous(random.point(16 * Fixed::kOne));
    const double large = std::ldexp(1, static_cast<int>(random.integer(0, 60)));
    for (Interval& value : f.values) value = random.attribute(large);
    if (random.one_in(2))
      for (Interval& w : f.w) w = random.clip_w(3);
    // Of the samples of a row, those beside the place where the value passes through zero.
    const auto plane = RationalInterpolation::of(f);
    if (!plane) continue;
    for (int x = -8; x < 8; ++x) {
      const Point sample = pixel_centre(x, trial % 16);
      const auto value = plane->at(sample);
      if (!value || distance(*value, 0) > rational_of(double{std::numeric_limits<float>::max()}))
        continue;
      ASSERT_TRUE(is_correctly_rounded(value_of(f, sample), *value))
          << "trial " << trial << " " << x;
      ++wide;
    }
  }
  EXPECT_GT(wide, least_of(50000));
}

// Exactly between two numbers, and by as little as the values can beside it.
TEST(CorrectRounding, HalfwayAndBesideIt) {
  const float ulp = 0x1p-23F;
  for (int step = 0; step < 8; ++step) {
    Interpolant f;
    f.kind = PrimitiveKind::line;
    f.positions = {homogeneous(at(0, 0)), homogeneous(at(2, 0)), {}};
    const float low = 1 + static_cast<float>(step) * ulp;
    f.values = {low, low + ulp, 0};
    const float even = step % 2 == 0 ? low : low + ulp;
    EXPECT_EQ(value_of(f, at(1, 0)), even);
    EXPECT_EQ(value_of(f, at(1 - 0x1p-16, 0)), low);
    EXPECT_EQ(value_of(f, at(1 + 0x1p-16, 0)), low + ulp);
  }
}

// Where a value passes through zero it is zero, and beside that it is not.
TEST(CorrectRounding, OfZeroAndWhatLiesBesideIt) {
  Interpolant f;
  f.positions = {homogeneous(at(0, 0)), homogeneous(at(3, 0)), homogeneous(at(0, 3))};
  f.values = {-1, 2, 2};
  EXPECT_EQ(interpolate_exact(f, at(1, 0)).low, 0);
  EXPECT_EQ(interpolate_exact(f, at(1, 0)).high, 0);
  EXPECT_EQ(value_of(f, at(1 + 0x1p-16, 0)), 0x1p-16F);
}

// A number of which no double is known is one of the two round it: the odd one, which float32 does
// not round to the wrong side.
TEST(CorrectRounding, OfTwoNeighboursTheOddOneIsTaken) {
  const double tie = 1 + 0x1p-24;
  EXPECT_EQ(middle({tie, next_above(tie)}), next_above(tie));
  EXPECT_EQ(middle({next_below(tie), tie}), next_below(tie));
  EXPECT_EQ(static_cast<float>(middle({tie, next_above(tie)})), 1 + 0x1p-23F);
  EXPECT_EQ(static_cast<float>(middle({next_below(tie), tie})), 1);
  EXPECT_EQ(middle({tie, tie}), tie);
}

}  // namespace
}  // namespace edgecase
