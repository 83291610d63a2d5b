// SPDX-License-Identifier: MIT
//
// The neighbours of a double are what the C library's nextafter finds.
#include "exact/interval.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace edgecase {
namespace {

using Limits = std::numeric_limits<double>;

void expect_neighbours(double value) {
  // Compared by their bits, but for the sign of zero, which no order tells.
  const double above = std::nextafter(value, Limits::infinity());
  const double below = std::nextafter(value, -Limits::infinity());
  ASSERT_EQ(next_above(value), above) << value;
  ASSERT_EQ(next_below(value), below) << value;
}

TEST(Neighbour, AtEveryPlaceWhereTheBitsTurnOver) {
  for (double sign : {1.0, -1.0}) {
    for (double value : {0.0, Limits::denorm_min(), Limits::min(), Limits::max(), 1.0, 2.0})
      expect_neighbours(sign * value);
    for (int exponent = -1074; exponent <= 1023; ++exponent) {
      const double power = std::ldexp(sign, exponent);
      expect_neighbours(power);
      expect_neighbours(std::nextafter(power, 0));
      expect_neighbours(std::nextafter(power, 4 * power));
    }
  }
}

TEST(Neighbour, InfinityHasOneNeighbourOnly) {
  EXPECT_EQ(next_above(Limits::infinity()), Limits::infinity());
  EXPECT_EQ(next_below(-Limits::infinity()), -Limits::infinity());
  EXPECT_EQ(next_below(Limits::infinity()), Limits::max());
  EXPECT_EQ(next_above(-Limits::infinity()), -Limits::max());
}

TEST(Neighbour, OfAnyBits) {
  std::mt19937_64 engine(11);
  for (int i = 0; i < 200000; ++i) {
    const auto value = std::bit_cast<double>(static_cast<std::uint64_t>(engine()));
    if (!std::isnan(value)) expect_neighbours(value);
  }
}

}  // namespace
}  // namespace edgecase
