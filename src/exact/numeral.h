// SPDX-License-Identifier: MIT
//
// Numerals: how people write exact coordinates, and how we print them.
//
// Accepted forms: a decimal ("10.5", "-3", "1e2"), a fraction ("21/2"), a whole number with a
// fraction ("10+3/256", "-1-1/16"), and "~DECIMAL", which takes the nearest multiple of 2^-16 (a
// tie goes to the even one). Without the tilde the number must be a multiple of 2^-16, or its
// nearest double (IEEE 754 binary64, ties to even) must be one other than 0 and below 2^36 in
// magnitude: 14.644210815429688 is what programs print for 14.6442108154296875, and is taken as
// that. 0.1 is refused, and the refusal names its two neighbours. Numbers are written as in JSON
// (no plus in front, no leading zeros, digits on both sides of a point); denominators are powers of
// two up to 65536.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "exact/fixed.h"

namespace edgecase {

// Why a numeral is refused, with the remedy: one sentence, no full stop at its end.
struct NumeralError {
  std::string message;
};

// Parses a numeral of the forms above. The result may lie outside the coordinate range (magnitude
// up to 2^40); the caller checks ranges. Digits beyond 40 are refused.
std::variant<Fixed, NumeralError> parse_numeral(std::string_view text);

// The canonical decimal of a number: exact, shortest, no exponent ("10.5", "-0.00390625", "3").
std::string to_decimal(Fixed value);

// The same as a fraction in lowest terms: "3", "7/2" with a denominator of 2 or 4, and a whole
// number and the rest for finer ones ("10+3/256", "-1-1/16", "3/256"); parse_numeral reads it back.
std::string to_fraction(Fixed value);

}  // namespace edgecase
