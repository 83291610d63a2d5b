// SPDX-License-Identifier: MIT
//
// The oracles' own arithmetic, on values worked out by hand.
#include "tests/oracles/rational.h"

#include <gtest/gtest.h>

#include "tests/oracles/nearby.h"

namespace edgecase::oracle {
namespace {

TEST(Rational, AddsMultipliesAndCompares) {
  EXPECT_TRUE(Rational(1, 3) + Rational(1, 6) == Rational(1, 2));
  EXPECT_TRUE(Rational(2, 3) * Rational(-9, 4) == Rational(-3, 2));
  EXPECT_TRUE(Rational(2, 3) / Rational(-4, 9) == Rational(-3, 2));
  EXPECT_TRUE(Rational(1, 3) < Rational(34, 100));
  EXPECT_TRUE(Rational(-1, 3) > Rational(-34, 100));
  EXPECT_EQ(Rational(1, -3).sign(), -1);
}

TEST(Rational, RoundsDown) {
  EXPECT_EQ(Rational(7, 2).floor(), 3);
  EXPECT_EQ(Rational(-7, 2).floor(), -4);
  EXPECT_EQ(Rational(-8, 2).floor(), -4);
  EXPECT_TRUE(Rational(-8, 2).is_whole());
  EXPECT_FALSE(Rational(7, 2).is_whole());
}

TEST(Rational, StaysExactBeyond64Bits) {
  const Int128 big = Int128{1} << 80;
  const Rational nearly(big - 1, big);
  EXPECT_TRUE(nearly < Rational(1));
  EXPECT_TRUE(Rational(1) - nearly == Rational(1, big));
  EXPECT_TRUE(nearly * Rational(big, 3) == Rational(big - 1, 3));
}

TEST(Nearby, IsOrderedAsADictionaryIs) {
  const Nearby<2> zero;
  EXPECT_TRUE(zero < amount(2));
  EXPECT_TRUE(amount(2) < amount(1));
  EXPECT_TRUE(amount(2) * Rational(1 << 30) < amount(1));
  EXPECT_TRUE(amount(1) < Nearby<2>(Rational(1, 1 << 30)));
  EXPECT_TRUE(amount(-1) < amount(-2));
  EXPECT_EQ(product(amount(1), amount(1)).c[2].sign(), 1);
}

}  // namespace
}  // namespace edgecase::oracle
