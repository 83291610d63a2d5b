// SPDX-License-Identifier: MIT
//
// float32 numbers as people write them, and as they are printed.
//
// A coordinate is a multiple of 2^-16 (exact/numeral.h); the other inputs of a vertex shader (w,
// clip coordinates, colours) are any float32 numbers. Whether a decimal is one is decided by its
// digits: 0.1 is not, 0.5 and 9.5367431640625e-07 are. So is 14.644210815429688, which
// exact/numeral.h reads as its nearest double, a multiple of 2^-16.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace edgecase {

struct Float32Numeral {
  float value = 0;     // the nearest float32 number, ties to even; never -0
  bool exact = false;  // whether the numeral is that number
  double wide = 0;     // the nearest double, for comparison with a range
};

// A decimal in JSON's grammar ("-12.5", "1e-3"), or a fraction of exact/numeral.h ("21/2",
// "-1-1/16"). Nothing for other texts and numbers beyond the largest float32 number.
std::optional<Float32Numeral> parse_float32(std::string_view text);

// All digits of a finite number, in JSON: "0.100000001490116119384765625", "1048576". Numbers far
// from 1 have an exponent: "9.5367431640625e-07".
std::string exact_decimal(float value);

// The shortest decimal whose nearest float32 number is this one: "0.1".
std::string short_decimal(float value);

// Sums and means of float32 numbers, rounded once.

// The float32 number nearest to the sum of `terms` divided by `divisor`, ties to even; never -0.
// Correct for up to 8 terms, each 0 or of magnitude 2^-149 to 2^148, despite any cancellation, and
// for whole divisors of 1 to 2^20.
float nearest_quotient(std::span<const double> terms, double divisor);

}  // namespace edgecase
