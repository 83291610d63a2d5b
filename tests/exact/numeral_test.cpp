// SPDX-License-Identifier: MIT
#include "exact/numeral.h"

#include <gtest/gtest.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <variant>

namespace edgecase {
namespace {

constexpr std::int64_t kOne = Fixed::kOne;
constexpr std::int64_t kMaxRaw = (std::int64_t{1} << 40) * kOne;

std::int64_t raw_of(const std::string& text) {
  const auto parsed = parse_numeral(text);
  if (const auto* error = std::get_if<NumeralError>(&parsed)) {
    ADD_FAILURE() << text << ": " << error->message;
    return 0;
  }
  return std::get<Fixed>(parsed).raw();
}

// The message, or "" when the numeral is accepted.
std::string error_of(const std::string& text) {
  const auto parsed = parse_numeral(text);
  const auto* error = std::get_if<NumeralError>(&parsed);
  return error == nullptr ? "" : error->message;
}

TEST(Numeral, ReadsDecimals) {
  EXPECT_EQ(raw_of("0"), 0);
  EXPECT_EQ(raw_of("-0"), 0);
  EXPECT_EQ(raw_of("-0.000"), 0);
  EXPECT_EQ(raw_of("10.5"), 21 * kOne / 2);
  EXPECT_EQ(raw_of("-3"), -3 * kOne);
  EXPECT_EQ(raw_of("1.50000"), 3 * kOne / 2);
  EXPECT_EQ(raw_of("0.0000152587890625"), 1);
  EXPECT_EQ(raw_of("-8191.9999847412109375"), -8192 * kOne + 1);
}

TEST(Numeral, ReadsExponents) {
  EXPECT_EQ(raw_of("1e2"), 100 * kOne);
  EXPECT_EQ(raw_of("1E+2"), 100 * kOne);
  EXPECT_EQ(raw_of("1.25e1"), 25 * kOne / 2);
  EXPECT_EQ(raw_of("-25e-2"), -kOne / 4);
  EXPECT_EQ(raw_of("152587890625e-16"), 1);
  EXPECT_EQ(raw_of("0e999"), 0);
  EXPECT_EQ(raw_of("0.5e-0"), kOne / 2);
}

TEST(Numeral, ReadsFractions) {
  EXPECT_EQ(raw_of("21/2"), 21 * kOne / 2);
  EXPECT_EQ(raw_of("-21/2"), -21 * kOne / 2);
  EXPECT_EQ(raw_of("1/65536"), 1);
  EXPECT_EQ(raw_of("7/1"), 7 * kOne);
  EXPECT_EQ(raw_of("10+3/256"), 10 * kOne + 3 * kOne / 256);
  EXPECT_EQ(raw_of("-1-1/16"), -kOne - kOne / 16);
  EXPECT_EQ(raw_of("-1+1/16"), -kOne + kOne / 16);
  EXPECT_EQ(raw_of("10-1/16"), 10 * kOne - kOne / 16);
  EXPECT_EQ(raw_of("0+5/4"), 5 * kOne / 4);
}

TEST(Numeral, TildeTakesTheNearestAndTiesTheEven) {
  EXPECT_EQ(raw_of("~0.1"), 6554);
  EXPECT_EQ(raw_of("~-0.1"), -6554);
  EXPECT_EQ(raw_of("~0.5"), kOne / 2);
  EXPECT_EQ(raw_of("~0.00000762939453125"), 0);  // 1/2 of a step: 0 is even
  EXPECT_EQ(raw_of("~0.00002288818359375"), 2);  // 3/2 of a step: 2 is even
  EXPECT_EQ(raw_of("~0.000007629394531250000001"), 1);
  EXPECT_EQ(raw_of("~0.00000762939453124999999"), 0);
  EXPECT_EQ(raw_of("~-0.00002288818359375"), -2);
  EXPECT_EQ(raw_of("~1e-400"), 0);
  EXPECT_EQ(raw_of("~0.99999999999"), kOne);
}

TEST(Numeral, RefusesWhatIsBetweenMultiplesAndNamesTheNeighbours) {
  const std::string tenth = error_of("0.1");
  EXPECT_NE(tenth.find("0.0999908447265625 and 0.100006103515625"), std::string::npos) << tenth;
  EXPECT_NE(tenth.find("\"~0.1\""), std::string::npos) << tenth;
  const std::string negative = error_of("-0.1");
  EXPECT_NE(negative.find("-0.100006103515625 and -0.0999908447265625"), std::string::npos);
  EXPECT_NE(error_of("1e-400").find("0 and 0.0000152587890625"), std::string::npos);
  EXPECT_NE(error_of("0.5000000000000002").find("0.5 and"), std::string::npos);
}

TEST(Numeral, TakesWhatProgramsPrintForTheDoubleOfAMultiple) {
  EXPECT_EQ(raw_of("14.644210815429688"), 959723);
  EXPECT_EQ(raw_of("-14.644210815429688"), -959723);
  EXPECT_EQ(raw_of("1.4644210815429688e1"), 959723);
  EXPECT_EQ(raw_of("8191.999984741211"), 8192 * kOne - 1);
  EXPECT_EQ(raw_of("0.50000000000000000000000000000000000001"), kOne / 2);
  EXPECT_EQ(raw_of("0.49999999999999999999"), kOne / 2);
  EXPECT_NE(error_of("14.64421081542969"), "");
  // Beside a power of two, doubles below are half as far apart as above: ties, and beyond them.
  EXPECT_EQ(raw_of("1.00000000000000011102230246251565404"), kOne);
  EXPECT_NE(error_of("1.00000000000000011102230246251565405"), "");
  EXPECT_EQ(raw_of("0.999999999999999944488848768742172979"), kOne);
  EXPECT_NE(error_of("0.999999999999999944488848768742172978"), "");
  // 2^24 + 2^-29 lies halfway to the next double, and goes to the even one.
  EXPECT_EQ(raw_of("16777216.00000000186264514923095703125"), (1 << 24) * kOne);
  EXPECT_NE(error_of("16777216.00000000186264514923095703126"), "");
}

double nearest_double(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

// Against the double that the C++ library reads: decimals with few and many digits beside
// multiples.
TEST(Numeral, TakesADecimalExactlyWhenItsDoubleIsAMultiple) {
  std::mt19937_64 random(13);
  int taken = 0;
  for (int i = 0; i < 100000; ++i) {
    const auto raw = static_cast<std::int64_t>(random() >> (13 + random() % 51));  // below 2^51
    const double near = std::ldexp(static_cast<double>(raw), -Fixed::kFractionBits);
    std::array<char, 64> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), near,
                                   std::chars_format::fixed, static_cast<int>(8 + random() % 12));
    std::string text(digits.data(), end.ptr);
    if (random() % 2 == 0) text.back() = static_cast<char>('0' + random() % 10);
    const double scaled = std::ldexp(nearest_double(text), Fixed::kFractionBits);
    const bool is_multiple = scaled == std::trunc(scaled) && scaled != 0;
    if (text.find_first_of("123456789") == std::string::npos) continue;
    ASSERT_EQ(error_of(text).empty(), is_multiple) << text;
    if (!is_multiple) continue;
    ++taken;
    ASSERT_EQ(raw_of(text), static_cast<std::int64_t>(scaled)) << text;
  }
  EXPECT_GT(taken, 10000);
}

TEST(Numeral, TakesTheShortestDecimalOfEveryDoubleOfAMultiple) {
  std::mt19937_64 random(17);
  for (int i = 0; i < 100000; ++i) {
    const auto raw = static_cast<std::int64_t>(random() >> (12 + random() % 52));  // below 2^52
    std::array<char, 64> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(),
                                   -std::ldexp(static_cast<double>(raw), -Fixed::kFractionBits));
    ASSERT_EQ(raw_of(std::string(digits.data(), end.ptr)), -raw);
  }
}

TEST(Numeral, RefusesEveryOtherForm) {
  for (const char* text : {"",
                           "-",
                           "+1",
                           "--1",
                           "1.",
                           ".5",
                           "-.5",
                           "1.e2",
                           "01",
                           "-00",
                           "1e",
                           "1e+",
                           "1e1.5",
                           "e5",
                           "0x10",
                           "NaN",
                           "inf",
                           "Infinity",
                           "1,5",
                           " 1",
                           "1 ",
                           "1 1/2",
                           "1_000",
                           "\xEF\xBC\x91",
                           "\xD9\xA1",
                           "1/0",
                           "1/3",
                           "1/",
                           "/2",
                           "1/-2",
                           "1//2",
                           "1/2/4",
                           "1/02",
                           "01/2",
                           "1+1",
                           "1+",
                           "1++1/2",
                           "1+-1/2",
                           "+1/2",
                           "--1/2",
                           "1.5/2",
                           "1/131072",
                           "10+/2",
                           "~",
                           "~~1",
                           "~1/2",
                           "~abc",
                           "~+1",
                           "1e1000",
                           "1e-1000",
                           "1e400",
                           "1099511627776.5",
                           "1099511627777",
                           "99999999999999999999",
                           "99999999999999999999/2",
                           "1099511627776+1/2",
                           "1/99999999999999999999999999999999999999999999",
                           "0.00000000000000000000000000000000000000000"}) {
    const std::string message = error_of(text);
    EXPECT_FALSE(message.empty()) << text;
    EXPECT_NE(message.find("; "), std::string::npos) << message;
    EXPECT_FALSE(message.ends_with('.')) << message;
  }
  EXPECT_NE(error_of("\0001").size(), 0U);
  EXPECT_FALSE(error_of(std::string("1\0", 2)).empty());
}

TEST(Numeral, AcceptsTheWholeRange) {
  EXPECT_EQ(raw_of("1099511627776"), kMaxRaw);
  EXPECT_EQ(raw_of("-1099511627776"), -kMaxRaw);
  EXPECT_EQ(raw_of("~1099511627775.9999999999"), kMaxRaw);
  EXPECT_EQ(raw_of("72057594037927936/65536"), kMaxRaw);
  EXPECT_EQ(raw_of("0.000000000000000000000000000000000000000"), 0);
}

TEST(Numeral, PrintsCanonicalDecimals) {
  EXPECT_EQ(to_decimal(Fixed()), "0");
  EXPECT_EQ(to_decimal(Fixed::from_integer(3)), "3");
  EXPECT_EQ(to_decimal(Fixed::from_raw(21 * kOne / 2)), "10.5");
  EXPECT_EQ(to_decimal(Fixed::from_raw(-kOne / 256)), "-0.00390625");
  EXPECT_EQ(to_decimal(Fixed::from_raw(-1)), "-0.0000152587890625");
  EXPECT_EQ(to_decimal(Fixed::from_raw(-8192 * kOne + 1)), "-8191.9999847412109375");
}

TEST(Numeral, PrintsFractions) {
  EXPECT_EQ(to_fraction(Fixed()), "0");
  EXPECT_EQ(to_fraction(Fixed::from_integer(-3)), "-3");
  EXPECT_EQ(to_fraction(Fixed::from_raw(7 * kOne / 2)), "7/2");
  EXPECT_EQ(to_fraction(Fixed::from_raw(-15 * kOne / 4)), "-15/4");
  EXPECT_EQ(to_fraction(Fixed::from_raw(10 * kOne + 3 * kOne / 256)), "10+3/256");
  EXPECT_EQ(to_fraction(Fixed::from_raw(-kOne - kOne / 16)), "-1-1/16");
  EXPECT_EQ(to_fraction(Fixed::from_raw(-1)), "-1/65536");
}

TEST(Numeral, EveryFractionPartComesBack) {
  for (std::int64_t raw = -2 * kOne; raw <= 2 * kOne; ++raw) {
    ASSERT_EQ(raw_of(to_decimal(Fixed::from_raw(raw))), raw);
    ASSERT_EQ(raw_of(to_fraction(Fixed::from_raw(raw))), raw);
  }
}

TEST(Numeral, RandomValuesComeBackFromEveryForm) {
  std::mt19937_64 random(7);
  std::uniform_int_distribution<std::int64_t> raws(-kMaxRaw, kMaxRaw);
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t raw = raws(random) >> (random() % 40);
    const std::string decimal = to_decimal(Fixed::from_raw(raw));
    ASSERT_EQ(raw_of(decimal), raw);
    ASSERT_EQ(raw_of(to_fraction(Fixed::from_raw(raw))), raw);
    ASSERT_EQ(raw_of("~" + decimal), raw);
    ASSERT_EQ(raw_of(decimal + "e0"), raw);
    ASSERT_EQ(raw_of(std::to_string(raw) + "/65536"), raw);
    const std::int64_t whole = raw / kOne;
    const std::int64_t rest = raw % kOne;
    const std::string sign = raw < 0 ? "-" : "";
    ASSERT_EQ(raw_of(sign + std::to_string(std::abs(whole)) + (raw < 0 ? "-" : "+") +
                     std::to_string(std::abs(rest)) + "/65536"),
              raw);
  }
}

// Nearest multiples against an independent rule: decimals with 8 digits, as integers.
TEST(Numeral, NearestAgreesWithIntegerArithmetic) {
  std::mt19937_64 random(11);
  constexpr std::int64_t kScale = 100'000'000;
  for (int i = 0; i < 20000; ++i) {
    const auto digits = static_cast<std::int64_t>(random() % (8192 * kScale));
    std::string fraction = std::to_string(digits % kScale);
    fraction.insert(0, 8 - fraction.size(), '0');
    const std::int64_t twice = 2 * digits * kOne;  // below 2 * 2^13 * 2^27 * 2^16 = 2^57
    const std::int64_t floor = digits * kOne / kScale;
    const std::int64_t beyond = twice - (2 * floor + 1) * kScale;  // sign: above the middle?
    const bool up = beyond > 0 || (beyond == 0 && floor % 2 != 0);
    ASSERT_EQ(raw_of("~" + std::to_string(digits / kScale) + "." + fraction), floor + (up ? 1 : 0));
  }
}

}  // namespace
}  // namespace edgecase
