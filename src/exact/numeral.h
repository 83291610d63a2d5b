// SPDX-License-Identifier: MIT
//
// Numerals: how people write exact coordinates, and how they are printed.
//
// Accepted forms: a decimal ("10.5", "-3", "1e2"), a fraction ("21/2"), a whole number with a
// fraction ("10+3/256", "-1-1/16"), and "~DECIMAL", the nearest multiple of 2^-16 (a tie goes to
// the even one). Without the tilde the number must be a multiple of 2^-16, or its nearest double
// (IEEE 754 binary64, ties to even) must be one that is not 0 and is below 2^36 in magnitude:
// programs print 14.644210815429688 for 14.6442108154296875, so it is read as that. 0.1 is
// rejected, and the message names its two neighbours. Numbers are written as in JSON (no leading
// plus or zeros, digits on both sides of a point); denominators are powers of two up to 65536.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "exact/fixed.h"

namespace edgecase {

// Why a numeral is rejected, and the remedy: one sentence without a full stop.
struct NumeralError {
  std::string message;
};

// Parses a numeral of the forms above. The magnitude may be up to 2^40, beyond the coordinate
// range; the caller checks ranges. More than 40 digits are rejected.
std::variant<Fixed, NumeralError> parse_numeral(std::string_view text);

// The canonical decimal of a number: exact, shortest, no exponent ("10.5", "-0.00390625", "3").
std::string to_decimal(Fixed value);

// The same as a fraction in lowest terms: "3", "7/2" with a denominator of 2 or 4, and for finer
// ones a whole number with a fraction ("10+3/256", "-1-1/16", "3/256"). parse_numeral reads it.
std::string to_fraction(Fixed value);

}  // namespace edgecase
