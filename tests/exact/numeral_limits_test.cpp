// SPDX-License-Identifier: MIT
//
// Numerals at the limits of what is accepted, and refusals word for word.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <variant>

#include "exact/numeral.h"

namespace edgecase {
namespace {

constexpr std::int64_t kMaxRaw = (std::int64_t{1} << 40) * Fixed::kOne;

std::string refusal(const std::string& text) {
  const auto parsed = parse_numeral(text);
  const auto* error = std::get_if<NumeralError>(&parsed);
  return error == nullptr ? "accepted" : error->message;
}

std::int64_t raw_of(const std::string& text) {
  const auto parsed = parse_numeral(text);
  const auto* value = std::get_if<Fixed>(&parsed);
  EXPECT_NE(value, nullptr) << refusal(text);
  return value == nullptr ? -1 : value->raw();
}

std::string no_numeral(const std::string& shown) {
  return "\"" + shown +
         " is no numeral; write a decimal like 10.5, a fraction like 21/2, a whole number with a "
         "fraction like 10+3/256, or ~ and a decimal for the nearest multiple of 1/65536";
}

TEST(NumeralRefusal, ShowsWhatWasWritten) {
  EXPECT_EQ(refusal("x"), no_numeral("x\""));
  EXPECT_EQ(refusal(""), no_numeral("\""));
}

TEST(NumeralRefusal, ShowsFortyEightBytesOfLongText) {
  const std::string forty_seven(47, 'x');
  EXPECT_EQ(refusal(forty_seven + "y"), no_numeral(forty_seven + "y\""));
  EXPECT_EQ(refusal(forty_seven + "yz"), no_numeral(forty_seven + "y...\""));
  EXPECT_EQ(refusal(std::string(200, 'x')), no_numeral(std::string(48, 'x') + "...\""));
}

// Two, three and four bytes a character; the cut goes back to where one starts.
TEST(NumeralRefusal, CutsBetweenCharacters) {
  const std::string forty_five(45, 'x');
  EXPECT_EQ(refusal(forty_five + "xx\xC3\xA9y"), no_numeral(forty_five + "xx...\""));
  EXPECT_EQ(refusal(forty_five + "x\xC3\xA9y"), no_numeral(forty_five + "x\xC3\xA9...\""));
  EXPECT_EQ(refusal(forty_five + "x\xE2\x82\xACy"), no_numeral(forty_five + "x...\""));
  EXPECT_EQ(refusal(forty_five + "\xF0\x9F\x98\x80y"), no_numeral(forty_five + "...\""));
  // Nothing but middles of characters: nothing is shown.
  EXPECT_EQ(refusal(std::string(60, '\x80')), no_numeral("...\""));
}

TEST(NumeralRefusal, SaysWhichLimitIsPassed) {
  EXPECT_EQ(refusal("0." + std::string(39, '0')), "accepted");
  const std::string digits = "0." + std::string(40, '0');
  EXPECT_EQ(refusal(digits), "\"" + digits + "\" has more than 40 digits; shorten it");
  const std::string nines(38, '9');
  EXPECT_EQ(refusal(nines + "/2"),
            "\"" + nines + "/2\" is too large; write a number of magnitude 2^40 at most");
  EXPECT_EQ(refusal("9" + nines + "/2"),
            "\"9" + nines + "/2\" has more than 40 digits; shorten it");
  EXPECT_EQ(refusal("1099511627777"),
            "\"1099511627777\" is too large; write a number of magnitude 2^40 at most");
  EXPECT_EQ(refusal("1/3"),
            "\"1/3\" has a denominator that is no power of two up to 65536; write the fraction "
            "with one, or ~ and a decimal for the nearest multiple of 1/65536");
  EXPECT_EQ(refusal("0.1"),
            "0.1 is no multiple of 1/65536; write one of its neighbours 0.0999908447265625 and "
            "0.100006103515625, or \"~0.1\" for the nearest");
}

TEST(NumeralRefusal, ExponentsEndAt999) {
  EXPECT_EQ(raw_of("0e999"), 0);
  EXPECT_EQ(raw_of("0e-999"), 0);
  for (const char* text : {"0e1000", "0e-1000", "0e9999", "0e-99999999999999999999"})
    EXPECT_EQ(refusal(text),
              "\"" + std::string(text) + "\" has an exponent beyond 999; write the number out");
}

TEST(NumeralLimits, SumsReachBothEnds) {
  EXPECT_EQ(raw_of("1099511627776-1/2"), kMaxRaw - Fixed::kOne / 2);
  EXPECT_EQ(raw_of("-1099511627776-0/1"), -kMaxRaw);
  EXPECT_EQ(raw_of("1099511627776+0/1"), kMaxRaw);
  EXPECT_NE(refusal("-1099511627776-1/65536"), "accepted");
  EXPECT_NE(refusal("1099511627776+1/65536"), "accepted");
}

// Wholes whose raw values would leave 64 bits, and come back as something small.
TEST(NumeralLimits, WholesDoNotOverflow) {
  for (const char* text : {"72057594037927936+1/2", "281474976710656+1/2", "-281474976710656-1/2",
                           "999999999999999999999999+1/2", "72057594037927937/1"})
    EXPECT_NE(refusal(text).find("too large"), std::string::npos) << text;
}

TEST(NumeralLimits, EveryTieGoesToTheEvenMultiple) {
  for (std::int64_t below = 0; below < 12; ++below) {
    // (below + 1/2) / 65536 has 17 decimals: that many half steps of 5^17.
    const std::string digits = std::to_string((2 * below + 1) * 762939453125);
    const std::string text = "~0." + std::string(17 - digits.size(), '0') + digits;
    EXPECT_EQ(raw_of(text), below % 2 == 0 ? below : below + 1) << text;
  }
}

}  // namespace
}  // namespace edgecase
