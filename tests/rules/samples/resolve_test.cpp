// SPDX-License-Identifier: MIT
#include "rules/samples/resolve.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <random>
#include <vector>

namespace edgecase {
namespace {

using Samples = std::vector<std::uint8_t>;

int by(ResolveMethod method, const Samples& samples) {
  return resolved(samples, method);
}

TEST(Resolve, AConstantStaysItselfToTheBit) {
  for (ResolveMethod method : values_of<ResolveMethod>())
    for (int value = 0; value < 256; ++value)
      for (std::size_t count = 1; count <= 16; ++count)
        EXPECT_EQ(by(method, Samples(count, static_cast<std::uint8_t>(value))), value)
            << name_of(method) << " of " << count;
}

TEST(Resolve, DrawnExamples) {
  const Samples half = {0, 0, 1, 1};
  EXPECT_EQ(by(ResolveMethod::nearest_even, half), 0);
  EXPECT_EQ(by(ResolveMethod::half_up, half), 1);
  EXPECT_EQ(by(ResolveMethod::nearest_even, {1, 1, 2, 2}), 2);
  EXPECT_EQ(by(ResolveMethod::half_up, {1, 1, 2, 2}), 2);
  EXPECT_EQ(by(ResolveMethod::truncated, {1, 1, 2, 2}), 1);
  EXPECT_EQ(by(ResolveMethod::truncated, {7, 7, 7, 6}), 6);
  EXPECT_EQ(by(ResolveMethod::nearest_even, {7, 7, 7, 6}), 7);
  EXPECT_EQ(by(ResolveMethod::nearest_even, {7, 6, 6, 6}), 6);
  EXPECT_EQ(by(ResolveMethod::first_sample, {9, 0, 255, 3}), 9);
  // (0 + 1)/2 goes up to 1, and (1 + 0)/2 too: more than the mean of 1/4.
  EXPECT_EQ(by(ResolveMethod::half_up_by_pairs, {0, 1, 0, 0}), 1);
  EXPECT_EQ(by(ResolveMethod::half_up_by_pairs, {0, 0, 4}), 2);
  EXPECT_EQ(by(ResolveMethod::half_up_by_pairs, {0, 0, 0, 8}), 2);
  EXPECT_EQ(by(ResolveMethod::half_up_by_pairs, {0, 0, 0, 0, 16, 0, 0, 64}), 10);
  EXPECT_EQ(by(ResolveMethod::nearest_even, {0, 255}), 128);
  EXPECT_EQ(by(ResolveMethod::nearest_even, {0, 0, 1}), 0);
  EXPECT_EQ(by(ResolveMethod::nearest_even, {0, 1, 1}), 1);
}

// Every sum of every number of samples: the nearest value is the one whose distance, times twice
// the count, is least.
TEST(Resolve, MeansAreTheNearestValues) {
  for (int count = 1; count <= 16; ++count)
    for (int sum = 0; sum <= 255 * count; ++sum) {
      Samples samples;
      for (int left = sum, i = count; i > 0; left -= samples.back(), --i)
        samples.push_back(static_cast<std::uint8_t>(std::min(left, 255)));
      const int even = by(ResolveMethod::nearest_even, samples);
      const int up = by(ResolveMethod::half_up, samples);
      const int down = by(ResolveMethod::truncated, samples);
      EXPECT_LE(2 * std::abs(even * count - sum), count);
      EXPECT_LE(2 * std::abs(up * count - sum), count);
      if (2 * std::abs(even * count - sum) == count) {
        EXPECT_EQ(even % 2, 0);
        EXPECT_GT(up * count, sum);
      } else {
        EXPECT_EQ(up, even);
      }
      EXPECT_LE(down * count, sum);
      EXPECT_GT((down + 1) * count, sum);
    }
}

TEST(Resolve, EveryMethodStaysInRange) {
  std::mt19937 random(3);
  int strict = 0;
  for (int round = 0; round < 20000; ++round) {
    Samples samples(1 + random() % 16);
    const auto span = static_cast<unsigned>(1 + random() % 4);
    const auto low = static_cast<unsigned>(random() % (256 - span));
    for (std::uint8_t& value : samples) value = static_cast<std::uint8_t>(low + random() % span);
    const ResolvedRange range = resolve_permitted(samples);
    const auto [least, greatest] = std::minmax_element(samples.begin(), samples.end());
    EXPECT_EQ(range.low, *least - 12);
    EXPECT_EQ(range.high, *greatest + 12);
    EXPECT_FALSE(range.contains(range.low - 1));
    EXPECT_FALSE(range.contains(range.high + 1));
    strict += range.low < range.high ? 1 : 0;
    for (ResolveMethod method : values_of<ResolveMethod>())
      EXPECT_TRUE(range.contains(by(method, samples))) << name_of(method);
  }
  EXPECT_GT(strict, 5000);
  EXPECT_TRUE(ResolvedRange().contains(0));
  EXPECT_FALSE(ResolvedRange().contains(1));
}

// In single precision a value that is no tie is the nearest all the same; a tie goes either way.
TEST(Resolve, SinglePrecisionMovesTiesAlone) {
  std::mt19937 random(4);
  int up = 0;
  int down = 0;
  for (int round = 0; round < 20000; ++round) {
    Samples samples(4);
    for (std::uint8_t& value : samples) value = static_cast<std::uint8_t>(random() % 256);
    const int sum = samples[0] + samples[1] + samples[2] + samples[3];
    const int value = by(ResolveMethod::float32_sum, samples);
    if (sum % 4 != 2) {
      EXPECT_EQ(value, by(ResolveMethod::half_up, samples));
      continue;
    }
    EXPECT_EQ(std::abs(4 * value - sum), 2);
    (4 * value > sum ? up : down) += 1;
  }
  EXPECT_GT(up, 100);
  EXPECT_GT(down, 100);
}

TEST(Resolve, NamesAreReadBack) {
  for (ResolveMethod method : values_of<ResolveMethod>()) {
    ResolveMethod read = ResolveMethod::nearest_even;
    EXPECT_TRUE(parse_name(name_of(method), read));
    EXPECT_EQ(read, method);
  }
  ResolveMethod read = ResolveMethod::truncated;
  EXPECT_FALSE(parse_name("median", read));
  EXPECT_EQ(read, ResolveMethod::truncated);
}

}  // namespace
}  // namespace edgecase
