// SPDX-License-Identifier: MIT
//
// The numbers that texels stand for, all codes of 8 bits, held against rationals.
#include "rules/textures/texture_image.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>

#include "tests/rules/textures/texels.h"

namespace edgecase {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(Unorm8, IsAQuotientBetweenNeighbouringDoubles) {
  for (int code = 0; code < 256; ++code) {
    const Interval number = unorm8_to_number(code);
    const Rational exact = Rational(code) / 255;
    EXPECT_LE(Rational(number.low), exact) << code;
    EXPECT_GE(Rational(number.high), exact) << code;
    // Only the numbers of 0 and 255 are doubles.
    const bool is_point = code == 0 || code == 255;
    EXPECT_EQ(number.high, is_point ? number.low : std::nextafter(number.low, 2)) << code;
  }
}

TEST(SrgbToLinear, HoldsTheFifthRootOfATwelfthPower) {
  for (int code = 0; code < 256; ++code) {
    const Interval number = srgb_to_linear(code);
    const Rational coded = Rational(code) / 255;
    const bool is_line = coded <= Rational(4045) / 100000;
    const Rational base = (coded + Rational(55) / 1000) / (Rational(1055) / 1000);
    // y = x^(12/5) where y^5 = x^12.
    const auto power_of = [&](double end) { return is_line ? Rational(end) : power(end, 5); };
    const Rational exact = is_line ? coded / (Rational(1292) / 100) : power(base, 12);
    EXPECT_LE(power_of(number.low), exact) << code;
    EXPECT_GE(power_of(number.high), exact) << code;
    EXPECT_LT(number.high - number.low, 0x1p-48 * number.high + (code == 0 ? 1 : 0)) << code;
  }
  EXPECT_EQ(ends_of(srgb_to_linear(0)), Ends(0.0, 0.0));
  EXPECT_EQ(ends_of(srgb_to_linear(255)), Ends(1.0, 1.0));
}

TEST(Decode, LeavesAlphaLinear) {
  const TextureLevel level{1, 1, {188, 188, 188, 188}};
  const Texel coded = decode(level, TextureFormat::srgb8).at(0, 0);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(ends_of(coded[k]), ends_of(srgb_to_linear(188)));
  EXPECT_EQ(ends_of(coded[3]), ends_of(unorm8_to_number(188)));
  const Texel plain = decode(level, TextureFormat::rgba8).at(0, 0);
  for (const Interval component : plain)
    EXPECT_EQ(ends_of(component), ends_of(unorm8_to_number(188)));
}

TEST(Decode, TakesFloatsAsTheyAre) {
  const TextureLevel level{2, 1, {0.1F, -3, 1e30F, 0x1p-149F, kInfinity, kNaN, 0, 1}};
  const DecodedLevel decoded = decode(level, TextureFormat::rgba32f);
  EXPECT_EQ(ends_of(decoded.at(0, 0)[0]), Ends(double{0.1F}, double{0.1F}));
  EXPECT_EQ(ends_of(decoded.at(0, 0)[1]), Ends(-3.0, -3.0));
  EXPECT_EQ(ends_of(decoded.at(0, 0)[2]), Ends(double{1e30F}, double{1e30F}));
  EXPECT_EQ(ends_of(decoded.at(0, 0)[3]), Ends(0x1p-149, 0x1p-149));
  EXPECT_EQ(ends_of(decoded.at(1, 0)[0]), Ends(kInfinity, kInfinity));
  EXPECT_EQ(ends_of(decoded.at(1, 0)[1]), Ends(-kInfinity, kInfinity));
}

TEST(Decode, StaysWithinTheCodesWhateverIsStored) {
  const TextureLevel level{1, 1, {-1, 256, kNaN, kInfinity}};
  const Texel texel = decode(level, TextureFormat::rgba8).at(0, 0);
  EXPECT_EQ(ends_of(texel[0]), Ends(0.0, 0.0));
  EXPECT_EQ(ends_of(texel[1]), Ends(1.0, 1.0));
  EXPECT_EQ(ends_of(texel[2]), Ends(0.0, 0.0));
  EXPECT_EQ(ends_of(texel[3]), Ends(1.0, 1.0));
}

TEST(Decode, TakesAnotherChainInPlaceOfTheTexturesOwn) {
  Texture texture;
  texture.levels = {{1, 1, {255, 0, 0, 0}}};
  EXPECT_EQ(decode(texture, {}).levels.size(), 1U);
  EXPECT_EQ(decode(texture, {}).levels[0].at(0, 0)[0].low, 1);
  const DecodedTexture other =
      decode(texture, {{2, 1, std::vector<float>(8, 0)}, {1, 1, {0, 0, 0, 0}}});
  ASSERT_EQ(other.levels.size(), 2U);
  EXPECT_EQ(other.levels[0].width, 2);
  EXPECT_EQ(other.levels[0].texels.size(), 2U);
}

TEST(DecodeBorder, ClampsToTheFormatsRange) {
  const std::array<float, 4> border{-1, 0.25F, 2, kNaN};
  for (const TextureFormat format : {TextureFormat::rgba8, TextureFormat::srgb8}) {
    const Texel texel = decode_border(border, format);
    EXPECT_EQ(ends_of(texel[0]), Ends(0.0, 0.0));
    EXPECT_EQ(ends_of(texel[1]), Ends(0.25, 0.25));
    EXPECT_EQ(ends_of(texel[2]), Ends(1.0, 1.0));
    EXPECT_EQ(ends_of(texel[3]), Ends(0.0, 0.0));
  }
  EXPECT_FALSE(std::signbit(decode_border({-0.0F, 0, 0, 0}, TextureFormat::rgba8)[0].low));
  const Texel texel = decode_border(border, TextureFormat::rgba32f);
  EXPECT_EQ(ends_of(texel[0]), Ends(-1.0, -1.0));
  EXPECT_EQ(ends_of(texel[2]), Ends(2.0, 2.0));
  EXPECT_EQ(ends_of(texel[3]), Ends(-kInfinity, kInfinity));
}

// Both pieces of either function, and their limits; 0.5 is ((0.5 + 0.055) / 1.055)^2.4 as linear.
TEST(SrgbNumbers, AreThoseOfTheCurve) {
  const auto expect_near = [](double number, double exact) {
    EXPECT_NEAR(number, exact, 0x1p-48 * exact) << exact;
  };
  for (const double beyond : {-2.0, 0.0}) {
    EXPECT_EQ(srgb_to_linear_number(beyond), 0);
    EXPECT_EQ(linear_to_srgb_number(beyond), 0);
  }
  for (const double beyond : {1.0, 3.0}) {
    expect_near(srgb_to_linear_number(beyond), 1);
    expect_near(linear_to_srgb_number(beyond), 1);
    EXPECT_LE(linear_to_srgb_number(beyond), 1);
  }
  expect_near(srgb_to_linear_number(0.0323), 0.0025);
  expect_near(linear_to_srgb_number(0.0025), 0.0323);
  expect_near(srgb_to_linear_number(0.5), 0.21404114048223255);
  expect_near(linear_to_srgb_number(0.21404114048223255), 0.5);
}

// Of every code: the linear number that the narrow interval holds, and back.
TEST(SrgbNumbers, GoToTheLinearNumberOfACodeAndBack) {
  for (int code = 0; code < 256; ++code) {
    const double coded = code / 255.0;
    const double linear = srgb_to_linear_number(coded);
    EXPECT_NEAR(linear, srgb_to_linear(code).low, 0x1p-47 * linear) << code;
    EXPECT_NEAR(linear_to_srgb_number(linear), coded, 0x1p-46 * coded) << code;
  }
}

TEST(SrgbNumbers, OfTexelsLeaveAlphaAsItIs) {
  const Interval half{0.5, 1}, linear{0.21404114048223255, 1};
  const Texel coded = srgb_coded(Texel{linear, 0, 1, linear});
  EXPECT_NEAR(coded[0].low, 0.5, 0x1p-48);
  EXPECT_NEAR(coded[0].high, 1, 0x1p-48);
  EXPECT_EQ(ends_of(coded[1]), Ends(0.0, 0.0));
  EXPECT_NEAR(coded[2].low, 1, 0x1p-48);
  EXPECT_EQ(ends_of(coded[3]), ends_of(linear));
  const Texel decoded = srgb_decoded(Texel{0, half, half, half});
  EXPECT_EQ(ends_of(decoded[0]), Ends(0.0, 0.0));
  EXPECT_NEAR(decoded[1].low, 0.21404114048223255, 0x1p-48);
  EXPECT_NEAR(decoded[2].low, 0.21404114048223255, 0x1p-48);
  EXPECT_EQ(ends_of(decoded[3]), ends_of(half));
  const DecodedLevel level{2, 1, {Texel{linear, 0, 0, 0}, Texel{0, linear, 0, 0}}};
  const DecodedTexture all = srgb_coded(DecodedTexture{2, TextureFormat::srgb8, {level, level}});
  for (const DecodedLevel& one : all.levels) {
    EXPECT_NEAR(one.at(0, 0)[0].low, 0.5, 0x1p-48);
    EXPECT_NEAR(one.at(1, 0)[1].low, 0.5, 0x1p-48);
  }
  EXPECT_EQ(all.levels.size(), 2U);
}

}  // namespace
}  // namespace edgecase
