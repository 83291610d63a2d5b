// SPDX-License-Identifier: MIT
//
// Directed rounding, against products and sums in 113 bits.
#include "rules/textures/directed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A number of so many bits, of either sign, at most 2^exponent apart from 1.
double drawn(RandomNumbers& random, int bits, int exponent) {
  const auto digits = static_cast<double>(random.integer(1, (std::int64_t{1} << bits) - 1));
  const double value =
      std::ldexp(digits, static_cast<int>(random.integer(-exponent, exponent)) - bits);
  return random.one_in(2) ? value : -value;
}

// `down` and `up` are the doubles next to the exact number, or that number itself.
void expect_tight(double down, double up, Wide exact) {
  EXPECT_LE(static_cast<Wide>(down), exact);
  EXPECT_GE(static_cast<Wide>(up), exact);
  if (static_cast<Wide>(down) == exact || static_cast<Wide>(up) == exact)
    EXPECT_EQ(down, up);
  else
    EXPECT_EQ(next_above(down), up);
}

TEST(Directed, SumsAndProductsAreTight) {
  RandomNumbers random(1);
  for (int i = 0; i < 200'000; ++i) {
    const int bits = random.one_in(2) ? 53 : 20;
    const double a = drawn(random, bits, 25);
    const double b = drawn(random, bits, 25);
    expect_tight(Down::sum(a, b), Up::sum(a, b), static_cast<Wide>(a) + static_cast<Wide>(b));
    expect_tight(Down::product(a, b), Up::product(a, b),
                 static_cast<Wide>(a) * static_cast<Wide>(b));
  }
}

TEST(Directed, QuotientsAndRootsAreTight) {
  RandomNumbers random(2);
  for (int i = 0; i < 200'000; ++i) {
    const double a = std::fabs(drawn(random, random.one_in(2) ? 53 : 24, 100));
    const double b = static_cast<double>(random.integer(1, 100));
    const Interval quotient = {Down::quotient(a, b), Up::quotient(a, b)};
    EXPECT_LE(static_cast<Wide>(quotient.low) * static_cast<Wide>(b), static_cast<Wide>(a));
    EXPECT_GE(static_cast<Wide>(quotient.high) * static_cast<Wide>(b), static_cast<Wide>(a));
    EXPECT_LE(quotient.high, next_above(quotient.low));

    const Interval root = {Down::root(a), Up::root(a)};
    const auto square = [](double value) {
      return static_cast<Wide>(value) * static_cast<Wide>(value);
    };
    EXPECT_LE(square(root.low), static_cast<Wide>(a));
    EXPECT_GE(square(root.high), static_cast<Wide>(a));
    EXPECT_LE(root.high, next_above(root.low));
    EXPECT_EQ(root.low == root.high, square(root.low) == static_cast<Wide>(a));
  }
}

TEST(Directed, ExactResultsDoNotMove) {
  EXPECT_EQ(Down::sum(0.5, -0.5), 0);
  EXPECT_EQ(Down::product(-3, 0.25), -0.75);
  EXPECT_EQ(Up::product(-3, 0.25), -0.75);
  EXPECT_EQ(Down::quotient(3, 4), 0.75);
  EXPECT_EQ(Up::quotient(3, 4), 0.75);
  EXPECT_EQ(Down::root(6.25), 2.5);
  EXPECT_EQ(Up::root(6.25), 2.5);
  EXPECT_EQ(root_of_squares<Down>({3, 4, 12}), 13);
  EXPECT_EQ(root_of_squares<Up>({3, 4, 12}), 13);
}

TEST(Directed, WhatIsTooSmallToTellMovesOutwards) {
  const double tiny = 0x1p-600;
  EXPECT_LT(Down::product(tiny, tiny), 0);
  EXPECT_GT(Up::product(tiny, tiny), 0);
  EXPECT_LT(Up::product(-tiny, tiny), 0x1p-1060);
  EXPECT_EQ(root_of_squares<Down>({tiny, tiny}), 0);
  EXPECT_GT(root_of_squares<Up>({tiny, tiny}), tiny);
  EXPECT_LT(Down::quotient(0x1p-1060, 3), 0x1p-1060 / 3);
  EXPECT_GT(Up::quotient(0x1p-1060, 3), 0x1p-1060 / 3);
}

TEST(Directed, TheLeastProductIsStillDistinguished) {
  const double root = 0x1p-480;
  EXPECT_EQ(Down::product(root, root), kLeastProduct);
  EXPECT_EQ(Up::product(root, root), kLeastProduct);
  EXPECT_EQ(Down::quotient(kLeastProduct, 1), kLeastProduct);
  EXPECT_EQ(Up::quotient(kLeastProduct, 1), kLeastProduct);
  EXPECT_EQ(Down::root(kLeastProduct), root);
  EXPECT_EQ(Up::root(kLeastProduct), root);
}

TEST(Directed, AroundIsSoManyDoublesWide) {
  EXPECT_EQ(around(1.5, 0).low, 1.5);
  EXPECT_EQ(around(1.5, 3).low, 1.5 - 0x3p-52);
  EXPECT_EQ(around(1.5, 3).high, 1.5 + 0x3p-52);
}

TEST(Directed, WhatIsTooLargeHasAnEndThatIsFinite) {
  EXPECT_EQ(Down::product(0x1p1000, 0x1p1000), std::numeric_limits<double>::max());
  EXPECT_EQ(Up::product(0x1p1000, 0x1p1000), kInfinity);
  EXPECT_EQ(Down::sum(0x1.8p1023, 0x1.8p1023), std::numeric_limits<double>::max());
  EXPECT_EQ(Up::sum(0x1.8p1023, 0x1.8p1023), kInfinity);
}

TEST(Directed, InfiniteOperandsStayInfinite) {
  EXPECT_EQ(Down::sum(kInfinity, 1), kInfinity);
  EXPECT_EQ(Up::sum(-kInfinity, 1), -kInfinity);
  EXPECT_EQ(Down::product(kInfinity, 2), kInfinity);
  EXPECT_EQ(Down::product(kInfinity, 0), 0);
  EXPECT_EQ(Down::quotient(kInfinity, 2), kInfinity);
  EXPECT_EQ(Up::root(kInfinity), kInfinity);
  EXPECT_EQ(Down::root(kInfinity), kInfinity);
}

TEST(Directed, AnEndThatIsNoNumberIsUnknown) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(is_everything(known(kNone)));
  EXPECT_EQ(known({kNone, 3}).high, 3);
  EXPECT_EQ(known({kNone, 3}).low, -kInfinity);
  EXPECT_EQ(known({3, kNone}).high, kInfinity);
  EXPECT_EQ(known({3, kNone}).low, 3);
}

TEST(Directed, MagnitudesAreAbsoluteValues) {
  EXPECT_EQ(magnitudes({-3, 2}).low, 0);
  EXPECT_EQ(magnitudes({-3, 2}).high, 3);
  EXPECT_EQ(magnitudes({-3, -2}).low, 2);
  EXPECT_EQ(magnitudes({-3, -2}).high, 3);
  EXPECT_EQ(magnitudes({2, 3}).low, 2);
}

}  // namespace
}  // namespace edgecase
