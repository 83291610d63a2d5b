// SPDX-License-Identifier: MIT
//
// Conversion to a depth buffer's format: every step of 16 bits and a share of those of 24, at the
// step, halfway to the next and beside both.
#include "rules/values/framebuffer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Which integer is stored, for depths that are k + part steps of 1 / largest.
std::int64_t stored(double depth, DepthFormat format) {
  const double largest = std::ldexp(1, bits_of(format)) - 1;
  const double steps = to_depth(depth, format) * largest;
  EXPECT_NEAR(steps, std::nearbyint(steps), 1e-8);
  return std::llround(steps);
}

struct Format {
  DepthFormat format;
  std::int64_t largest;
  std::int64_t stride;
};
constexpr Format kFormats[] = {{DepthFormat::depth16, 65535, 1},
                               {DepthFormat::depth24, 16777215, 97}};

// The sign of depth * largest - doubled/2, without rounding.
int compare(double depth, std::int64_t largest, std::int64_t doubled) {
  const Wide difference = 2 * static_cast<Wide>(depth) * largest - doubled;
  return difference < 0 ? -1 : difference > 0 ? 1 : 0;
}

TEST(ToDepth, GoesToTheNearestStep) {
  for (const auto& [format, largest, stride] : kFormats)
    for (std::int64_t k = 0; k < largest; k += stride) {
      const double half = (static_cast<double>(k) + 0.5) / static_cast<double>(largest);
      const double beside[] = {half, std::nextafter(half, 0), std::nextafter(half, 1)};
      for (const double depth : beside) {
        const int side = compare(depth, largest, 2 * k + 1);
        const std::int64_t even = k % 2 == 0 ? k : k + 1;
        ASSERT_EQ(stored(depth, format), side < 0 ? k : side > 0 ? k + 1 : even) << k;
      }
      const double step = static_cast<double>(k) / static_cast<double>(largest);
      ASSERT_EQ(to_depth(step, format), step);
    }
}

// Of a narrower buffer every depth is a multiple of 1/(2^bits - 1); of one that loses bits, every
// integer is a multiple of 2 or 4, but for the largest.
TEST(ToDepth, KeepsTheBitsOfAnAlternative) {
  const auto code = [](double depth, DepthFormat format, DepthBits bits, int kept) {
    const double steps = to_depth(depth, format, bits) * (std::ldexp(1, kept) - 1);
    EXPECT_NEAR(steps, std::nearbyint(steps), 1e-8);
    return std::llround(steps);
  };
  // 0.3 (2^n - 1) for n = 24, 22, 16, 15.
  EXPECT_EQ(code(0.3, DepthFormat::depth24, DepthBits::as_set, 24), 5033164);
  EXPECT_EQ(code(0.3, DepthFormat::depth24, DepthBits::fewer, 22), 1258291);
  EXPECT_EQ(code(0.3, DepthFormat::depth24, DepthBits::sixteen, 16), 19660);
  EXPECT_EQ(code(0.3, DepthFormat::depth16, DepthBits::as_set, 16), 19660);
  EXPECT_EQ(code(0.3, DepthFormat::depth16, DepthBits::fewer, 15), 9830);
  EXPECT_EQ(code(0.3, DepthFormat::depth16, DepthBits::sixteen, 16), 19660);
  // 19661.5 of 65535 between 19660 and 19662, and 5033165.6 of 2^24 - 1 between 5033164 and
  // 5033168.
  EXPECT_EQ(code(19661.5 / 65535, DepthFormat::depth16, DepthBits::lowest_lost, 16), 19662);
  EXPECT_EQ(code(5033165.6 / 16777215, DepthFormat::depth24, DepthBits::lowest_lost, 24), 5033164);
  for (const DepthBits bits : values_of<DepthBits>()) {
    EXPECT_EQ(to_depth(0, DepthFormat::depth24, bits), 0);
    EXPECT_EQ(to_depth(1, DepthFormat::depth24, bits), 1);
    EXPECT_EQ(to_depth(0.3, DepthFormat::depth32f, bits), double{0.3f});
  }
}

TEST(ToDepth, OfTwoEquallyNearGoesToTheEvenStep) {
  // Half of an odd number of steps.
  EXPECT_EQ(stored(0.5, DepthFormat::depth16), 32768);
  EXPECT_EQ(stored(0.5, DepthFormat::depth24), 8388608);
}

TEST(ToDepth, ClampsFirst) {
  for (const DepthFormat format :
       {DepthFormat::depth16, DepthFormat::depth24, DepthFormat::depth32f}) {
    EXPECT_EQ(to_depth(-0.25, format), 0);
    EXPECT_EQ(to_depth(-kInfinity, format), 0);
    EXPECT_EQ(to_depth(1.25, format), 1);
    EXPECT_EQ(to_depth(kInfinity, format), 1);
    EXPECT_EQ(to_depth(std::numeric_limits<double>::quiet_NaN(), format), 0);
    EXPECT_EQ(to_depth(0, format), 0);
    EXPECT_EQ(to_depth(1, format), 1);
  }
}

TEST(ToDepth, Float32IsTheNearestFloat) {
  EXPECT_EQ(to_depth(0.1, DepthFormat::depth32f), static_cast<double>(0.1F));
  EXPECT_NE(to_depth(0.1, DepthFormat::depth32f), 0.1);
  EXPECT_EQ(to_depth(std::numeric_limits<double>::quiet_NaN(), DepthFormat::depth32f), 0);
}

TEST(DepthFormatBits, Are16And24) {
  EXPECT_EQ(bits_of(DepthFormat::depth16), 16);
  EXPECT_EQ(bits_of(DepthFormat::depth24), 24);
  EXPECT_EQ(bits_of(DepthFormat::depth32f), 0);
  EXPECT_EQ(bits_of(DepthFormat::none), 0);
}

TEST(DepthPermitted, IsEitherNeighbour) {
  for (const auto& [format, largest, stride] : kFormats)
    for (std::int64_t k = 1; k < largest; k += stride) {
      const auto steps = [&, most = largest](std::int64_t n) {
        return static_cast<double>(n) / static_cast<double>(most);
      };
      const double half = (static_cast<double>(k) + 0.5) / static_cast<double>(largest);
      const Interval permitted = depth_permitted(half, format);
      ASSERT_EQ(permitted.low, steps(k));
      ASSERT_EQ(permitted.high, steps(k + 1));
      const auto near = static_cast<double>(static_cast<float>(steps(k)));
      for (const double depth : {near, steps(k), std::nextafter(steps(k), 0)}) {
        const int side = compare(depth, largest, 2 * k);
        const Interval at_step = depth_permitted(depth, format);
        ASSERT_EQ(at_step.low, steps(side < 0 ? k - 1 : k));
        ASSERT_EQ(at_step.high, steps(side > 0 ? k + 1 : k));
      }
    }
}

TEST(DepthPermitted, OfAStepThatIsADoubleIsThatStep) {
  for (const DepthFormat format : {DepthFormat::depth16, DepthFormat::depth24})
    for (const double depth : {0.0, 1.0}) {
      EXPECT_EQ(depth_permitted(depth, format).low, depth);
      EXPECT_EQ(depth_permitted(depth, format).high, depth);
    }
}

TEST(DepthPermitted, HoldsWhatIsStoredAndNothingBeyondTheBuffer) {
  for (const DepthFormat format : {DepthFormat::depth16, DepthFormat::depth24}) {
    for (const Interval depth : {Interval(0.2, 0.3), Interval(-1, 0.1), Interval(0.9, 4)}) {
      const Interval permitted = depth_permitted(depth, format);
      EXPECT_TRUE(permitted.contains(to_depth(depth.low, format)));
      EXPECT_TRUE(permitted.contains(to_depth(depth.high, format)));
      EXPECT_GE(permitted.low, 0);
      EXPECT_LE(permitted.high, 1);
      EXPECT_LT(width_of(permitted), 0.1 + 1e-4);
    }
    for (const auto& [depth, clamped] : {std::pair{Interval(-3, -2), 0}, {Interval(2, 3), 1}}) {
      EXPECT_EQ(depth_permitted(depth, format).low, clamped);
      EXPECT_EQ(depth_permitted(depth, format).high, clamped);
    }
    const Interval all = depth_permitted(Interval::everything(), format);
    EXPECT_EQ(all.low, 0);
    EXPECT_EQ(all.high, 1);
  }
}

TEST(DepthPermitted, AFloat32DepthIsTheDepth) {
  const Interval one = depth_permitted(static_cast<double>(0.1F), DepthFormat::depth32f);
  EXPECT_EQ(one.low, static_cast<double>(0.1F));
  EXPECT_EQ(one.high, static_cast<double>(0.1F));
  const Interval between = depth_permitted({0.1, 0.2}, DepthFormat::depth32f);
  EXPECT_EQ(between.low, static_cast<double>(0.1F));
  EXPECT_EQ(between.high, static_cast<double>(0.2F));
  const Interval beyond = depth_permitted({-0x1p-28, 1 + 0x1p-23}, DepthFormat::depth32f);
  EXPECT_EQ(beyond.low, -0x1p-28);
  EXPECT_EQ(beyond.high, 1 + 0x1p-23);
  // Either as it is or clamped.
  const Interval below = depth_permitted(-0.6875, DepthFormat::depth32f);
  EXPECT_EQ(below.low, -0.6875);
  EXPECT_EQ(below.high, 0);
}

TEST(DepthPermitted, AFormatHoldsItsOwnNumbersAlone) {
  EXPECT_TRUE(is_depth_of(-0x1p-28, DepthFormat::depth32f));
  EXPECT_FALSE(is_depth_of(0.1, DepthFormat::depth32f));
  EXPECT_TRUE(is_depth_of(1.0 / 65535, DepthFormat::depth16));
  EXPECT_FALSE(is_depth_of(1.5 / 65535, DepthFormat::depth16));
  EXPECT_FALSE(is_depth_of(-1.0 / 65535, DepthFormat::depth16));
}

// Between the codes 100 and 101 a stored one may be one beyond, and no two.
TEST(DepthPermitted, OneCodeBeyondIsDistinguishedFromTwo) {
  for (const auto& [format, largest, stride] : kFormats) {
    const auto within = [&, format = format, most = static_cast<double>(largest)](
                            double code, double low, double high) {
      return is_within_one_code(code / most, {low / most, high / most}, format);
    };
    for (int code = 97; code <= 104; ++code)
      EXPECT_EQ(within(code, 100, 101), code >= 99 && code <= 102) << code;
    // What the format does not hold is no code of it.
    EXPECT_FALSE(within(100.5, 100, 101));
    EXPECT_FALSE(within(-1, 0, 0));
    EXPECT_TRUE(within(1, 0, 0));
  }
  EXPECT_FALSE(is_within_one_code(0.5, 0.5, DepthFormat::depth32f));
  EXPECT_FALSE(is_within_one_code(0.5, 0.5, DepthFormat::none));
}

}  // namespace
}  // namespace edgecase
