// SPDX-License-Identifier: MIT
#include "casefile/json/numbers.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace edgecase {
namespace {

bool is_exact(const char* text) {
  const auto parsed = parse_float32(text);
  EXPECT_TRUE(parsed.has_value()) << text;
  return parsed && parsed->exact;
}

TEST(FloatNumeral, TellsFloat32NumbersFromOthersByTheirDigits) {
  for (const char* text :
       {"0", "-0", "0.0e5", "1", "0.5", "-12.25", "1e3", "1048576", "9.5367431640625e-07",
        "0.00000095367431640625", "16777216", "33554432", "0.100000001490116119384765625",
        "1.40129846432481707092372958328991613128026194187651577175706828388979108268586060148663"
        "818836212158203125e-45",
        "340282346638528859811704183484516925440", "21/2", "10+3/256", "-1-1/16", "1.50e1"})
    EXPECT_TRUE(is_exact(text)) << text;
  for (const char* text : {"0.1", "16777217", "1e-60", "0.1000000014901161193847656250001",
                           "340282346638528859811704183484516925441", "256+1/65536"})
    EXPECT_FALSE(is_exact(text)) << text;
  EXPECT_TRUE(is_exact("128+1/65536"));
  EXPECT_TRUE(is_exact("14.644210815429688"));  // a multiple of 2^-16, as programs print it
}

TEST(FloatNumeral, RefusesWhatIsNoDecimal) {
  for (const char* text :
       {"",    "-",  ".5", "1.",  "+1",   "01",     "1e",  "1e+", "0x1", "nan",
        "inf", "1 ", " 1", "1,5", "1e39", "-1e400", "1/3", "1/0", "--1", "1e5.0"})
    EXPECT_FALSE(parse_float32(text).has_value()) << text;
  EXPECT_EQ(parse_float32("1e-99999999999999999999")->value, 0);
  EXPECT_FALSE(std::signbit(parse_float32("-1e-60")->value));
  EXPECT_FALSE(std::signbit(parse_float32("-0")->value));
}

// Is it a multiple of 2^-16 and, as far as numerals go, one that its double stands for?
bool is_multiple(float value) {
  return value != 0 && std::fabs(value) < 0x1p36F &&
         std::ldexp(value, 16) == std::trunc(std::ldexp(value, 16));
}

// Every float32 number, written out, is itself; a digit more, and it is none, unless its double is
// a multiple of 2^-16.
TEST(FloatNumeral, WritesNumbersThatComeBack) {
  std::mt19937 random(1);
  for (int round = 0; round < 20000; ++round) {
    const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (!std::isfinite(value)) continue;
    const std::string text = exact_decimal(value);
    const auto parsed = parse_float32(text);
    ASSERT_TRUE(parsed.has_value()) << text;
    EXPECT_TRUE(parsed->exact) << text;
    EXPECT_EQ(parsed->value, value) << text;
    EXPECT_EQ(parse_float32(short_decimal(value))->value, value);
    if (text.find('e') == std::string::npos) {
      const std::string more = text + (text.find('.') == std::string::npos ? ".0" : "") + "0001";
      double wide = 0;
      std::from_chars(more.data(), more.data() + more.size(), wide);
      EXPECT_EQ(parse_float32(more)->exact, is_multiple(value) && wide == value) << more;
    }
  }
  EXPECT_EQ(exact_decimal(0.1F), "0.100000001490116119384765625");
  EXPECT_EQ(exact_decimal(1048576), "1048576");
  EXPECT_EQ(exact_decimal(0), "0");
  EXPECT_EQ(exact_decimal(-2.5F), "-2.5");
  EXPECT_EQ(exact_decimal(std::ldexp(1.0F, -20)), "9.5367431640625e-07");
}

}  // namespace
}  // namespace edgecase
