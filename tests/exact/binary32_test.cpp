// SPDX-License-Identifier: MIT
//
// The processor's single precision is the oracle: same operands, same bits.
#include "exact/binary32.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/share.h"

namespace edgecase {
namespace {

// A number of our own beside the processor's.
struct Pair {
  Binary32 ours;
  float theirs;
};

Pair of_raw(std::int64_t raw) {
  return {Binary32::from_fixed(Fixed::from_raw(raw)), static_cast<float>(raw) / 65536.0f};
}

// The value of ours, which has at most 24 bits, by exact comparison with a float.
::testing::AssertionResult same(const Pair& pair) {
  // Ours minus theirs is zero exactly when they are equal: theirs is taken apart into integers.
  int exponent = 0;
  const float fraction = std::frexp(pair.theirs, &exponent);
  Binary32 expected = Binary32::from_integer(static_cast<std::int64_t>(std::ldexp(fraction, 24)));
  const Binary32 two = Binary32::from_integer(2);
  for (int i = exponent - 24; i < 0; ++i) expected = expected / two;
  for (int i = exponent - 24; i > 0; --i) expected = expected * two;
  if (expected == pair.ours) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "not " << pair.theirs;
}

Pair plus(Pair a, Pair b) {
  return {a.ours + b.ours, a.theirs + b.theirs};
}
Pair minus(Pair a, Pair b) {
  return {a.ours - b.ours, a.theirs - b.theirs};
}
Pair times(Pair a, Pair b) {
  return {a.ours * b.ours, a.theirs * b.theirs};
}
Pair over(Pair a, Pair b) {
  return {a.ours / b.ours, a.theirs / b.theirs};
}

// Sums of numbers ever further apart, and quotients of the longest and shortest significands.
TEST(Binary32, RoundsWhereOneOperandIsFarSmaller) {
  const std::int64_t significands[] = {1, 3, 5, 8388609, 16777213, 16777215};
  const Binary32 two = Binary32::from_integer(2);
  for (const std::int64_t a : significands)
    for (const std::int64_t b : significands) {
      const Pair large{Binary32::from_integer(a), static_cast<float>(a)};
      Pair small{Binary32::from_integer(b), static_cast<float>(b)};
      EXPECT_TRUE(same(over(large, small))) << a << " / " << b;
      EXPECT_TRUE(same(over({-large.ours, -large.theirs}, small))) << -a << " / " << b;
      for (int shift = 0; shift < 80; ++shift) {
        EXPECT_TRUE(same(plus(large, small))) << a << " + " << b << " * 2^-" << shift;
        EXPECT_TRUE(same(minus(large, small))) << a << " - " << b << " * 2^-" << shift;
        EXPECT_TRUE(same(minus(small, large))) << b << " * 2^-" << shift << " - " << a;
        small = {small.ours / two, small.theirs / 2};
      }
    }
}

TEST(Binary32, ComputesWhatTheProcessorDoes) {
  std::mt19937_64 random(share_seed(5));
  for (int i = 0; i < share_of(300'000); ++i) {
    // Raw values of every size, so that sums cancel, swallow and round in every way.
    const auto draw = [&] {
      const int bits = static_cast<int>(random() % 30);
      const auto raw = static_cast<std::int64_t>(random() % (std::uint64_t{1} << bits));
      return of_raw(random() % 2 == 0 ? raw : -raw);
    };
    const Pair a = draw();
    const Pair b = draw();
    const Pair c = draw();
    ASSERT_TRUE(same(a));
    ASSERT_TRUE(same(plus(a, b))) << a.theirs << " + " << b.theirs;
    ASSERT_TRUE(same(minus(a, b))) << a.theirs << " - " << b.theirs;
    ASSERT_TRUE(same(times(a, b))) << a.theirs << " * " << b.theirs;
    if (b.theirs == 0) continue;
    const Pair quotient = over(a, b);
    ASSERT_TRUE(same(quotient)) << a.theirs << " / " << b.theirs;
    ASSERT_TRUE(same(plus(c, times(quotient, c)))) << a.theirs << " / " << b.theirs;
    ASSERT_TRUE(same(plus(c, quotient))) << c.theirs << " + " << quotient.theirs;
    EXPECT_EQ(quotient.ours.floor(), static_cast<std::int64_t>(std::floor(quotient.theirs)));
    EXPECT_EQ(quotient.ours.ceil(), static_cast<std::int64_t>(std::ceil(quotient.theirs)));
    EXPECT_EQ(quotient.ours.truncate(), static_cast<std::int64_t>(quotient.theirs));
    EXPECT_EQ(quotient.ours.is_zero(), quotient.theirs == 0);
    EXPECT_EQ(quotient.ours.is_negative(), quotient.theirs < 0);
  }
}

TEST(Binary32, RoundsTiesToEven) {
  const auto sum = [](std::int64_t a, std::int64_t b) {
    return Binary32::from_integer(a) + Binary32::from_integer(b);
  };
  const std::int64_t limit = std::int64_t{1} << 24;
  EXPECT_EQ(sum(limit, 1), Binary32::from_integer(limit));
  EXPECT_EQ(sum(limit + 2, 1), Binary32::from_integer(limit + 4));
  EXPECT_EQ(Binary32::from_integer(limit + 1), Binary32::from_integer(limit));
  EXPECT_EQ(Binary32::from_integer(2 * limit - 1), Binary32::from_integer(2 * limit));
  // What lies just beyond the middle, by a number far too small to be seen, does count.
  const Binary32 third = Binary32::from_integer(1) / Binary32::from_integer(3);
  EXPECT_EQ((third * Binary32::from_integer(3)), Binary32::from_integer(1));
}

TEST(Binary32, SwallowsWhatIsFarTooSmall) {
  Binary32 small = Binary32::from_integer(1);
  for (int i = 0; i < 100; ++i) small = small / Binary32::from_integer(2);
  const Binary32 one = Binary32::from_integer(1);
  EXPECT_EQ(one + small, one);
  EXPECT_EQ(one - small, one);
  EXPECT_EQ(small + one, one);
  EXPECT_EQ(small - one, -one);
  EXPECT_EQ(small.floor(), 0);
  EXPECT_EQ(small.ceil(), 1);
  EXPECT_EQ((-small).floor(), -1);
  EXPECT_EQ((-small).ceil(), 0);
  EXPECT_EQ((-small).truncate(), 0);
}

}  // namespace
}  // namespace edgecase
