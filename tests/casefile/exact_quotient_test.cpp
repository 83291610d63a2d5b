// SPDX-License-Identifier: MIT
//
// Sums over divisors, rounded once, against rational arithmetic.
#include "casefile/json/numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace edgecase {
namespace {

using Fraction = boost::multiprecision::cpp_rational;

Fraction magnitude(const Fraction& value) {
  return value < 0 ? Fraction(-value) : value;
}

Fraction exact_quotient(const std::vector<double>& terms, int divisor) {
  Fraction sum;
  for (const double term : terms) sum += Fraction(term);
  return sum / divisor;
}

// Is no float32 number nearer to the value, and none as near that is even where this one is odd?
bool is_nearest(float found, const Fraction& value) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  std::uint32_t bits = 0;
  std::memcpy(&bits, &found, sizeof bits);
  const Fraction error = magnitude(Fraction(found) - value);
  for (const float towards : {-kInfinity, kInfinity}) {
    const float other = std::nextafter(found, towards);
    if (!std::isfinite(other)) continue;
    const Fraction others = magnitude(Fraction(other) - value);
    if (others < error || (others == error && (bits & 1) != 0)) return false;
  }
  return true;
}

void expect_nearest(const std::vector<double>& terms, int divisor) {
  const float found = nearest_quotient(terms, divisor);
  EXPECT_TRUE(is_nearest(found, exact_quotient(terms, divisor)))
      << found << " of " << ::testing::PrintToString(terms) << " / " << divisor;
  EXPECT_FALSE(std::signbit(found) && found == 0);
}

TEST(ExactQuotient, IsExactWhereItCanBe) {
  EXPECT_EQ(nearest_quotient(std::array{1.0, 2.0, 3.0, 6.0}, 4), 3);
  EXPECT_EQ(nearest_quotient(std::array{1e30, 1.0, -1e30, 2.0}, 1), 3);
  EXPECT_EQ(nearest_quotient(std::array{-0.0, -0.0}, 2), 0);
  EXPECT_FALSE(std::signbit(nearest_quotient(std::array{-0.0, -0.0}, 2)));
  EXPECT_EQ(nearest_quotient({}, 1), 0);
  const double largest = std::numeric_limits<float>::max();
  EXPECT_EQ(nearest_quotient(std::array{largest, largest, largest, largest}, 4),
            std::numeric_limits<float>::max());
}

// Half a unit in the last place of a float32, and the least more or less, which a double that holds
// the sum has lost.
TEST(ExactQuotient, DecidesTiesByWhatIsFarBelow) {
  const double half = std::ldexp(1.0, -24);
  const double least = std::ldexp(1.0, -149);
  const float next = std::nextafter(1.0F, 2.0F);
  EXPECT_EQ(nearest_quotient(std::array{1.0, half}, 1), 1.0F);
  EXPECT_EQ(nearest_quotient(std::array{1.0, half, least}, 1), next);
  EXPECT_EQ(nearest_quotient(std::array{1.0, half, -least}, 1), 1.0F);
  EXPECT_EQ(nearest_quotient(std::array{1.0, 3 * half, -least}, 1), next);
  EXPECT_EQ(nearest_quotient(std::array{-1.0, -half, -least}, 1), -next);
  EXPECT_EQ(nearest_quotient(std::array{least}, 2), 0.0F);  // a tie with 0, which is even
  EXPECT_EQ(nearest_quotient(std::array{least, least, least}, 2), static_cast<float>(2 * least));
}

TEST(ExactQuotient, RandomSumsAreRoundedOnce) {
  std::mt19937_64 random(6);
  const auto below = [&](int most) {
    return static_cast<int>(random() % static_cast<std::uint64_t>(most));
  };
  for (int round = 0; round < 40000; ++round) {
    const int spread = 1 + below(round % 2 == 0 ? 8 : 270);
    const int middle = below(277 - spread) - 149;
    std::vector<double> terms;
    for (int i = 0; i < 1 + below(8); ++i) {
      const auto mantissa = static_cast<double>(below(1 << 24));
      const int exponent = std::max(-149, middle + below(spread) - 24);
      const double weight = round % 3 == 0 ? 1.0 : static_cast<double>(1 + below(1 << 20));
      terms.push_back(std::ldexp(below(2) == 0 ? mantissa : -mantissa, exponent) * weight);
    }
    // Terms that cancel but for a little.
    if (round % 5 == 0 && terms.size() > 1) terms[1] = std::nextafter(-terms[0], 0.0);
    const int divisor = round % 3 == 0 ? 1 << below(3) : 1 + below(1 << 20);
    if (magnitude(exact_quotient(terms, divisor)) > Fraction(std::numeric_limits<float>::max()))
      continue;
    expect_nearest(terms, divisor);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace edgecase
