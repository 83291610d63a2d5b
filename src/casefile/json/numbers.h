// SPDX-License-Identifier: MIT
//
// Numbers of a case file: exact coordinates, whole numbers and colours. They are judged by their
// digits as written, not by a rounded double.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "casefile/json/fields.h"
#include "casefile/json/json_layout.h"
#include "exact/fixed.h"
#include "model/scene.h"

namespace edgecase {

// float32 numbers as people write them, and as they are printed.
//
// A coordinate is a multiple of 2^-16 (exact/numeral.h); the other inputs of a vertex shader (w,
// clip coordinates, colours) are any float32 numbers. Whether a decimal is one is decided by its
// digits: 0.1 is not, 0.5 and 9.5367431640625e-07 are. So is 14.644210815429688, which
// exact/numeral.h reads as its nearest double, a multiple of 2^-16.

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

// The largest numbers of characters in a number written as a string, as in the schema: of a
// coordinate, and of a float32 number with all its digits.
constexpr int kMostNumeralCharacters = 64;
constexpr int kMostCharacters = 200;

// A closed range of exact numbers.
struct FixedRange {
  Fixed low;
  Fixed high;
};

// An exact numeral, as a JSON number or a string (see exact/numeral.h), inside `range`. A "~"
// numeral adds a note with the number that was read.
std::optional<Fixed> read_coordinate(const Place& place, std::string_view what, FixedRange range,
                                     Findings& findings);

// A closed range of whole numbers.
struct IntegerRange {
  int low = 0;
  int high = 0;
};

// A JSON number with a whole value inside `range`; 8.0 and 1e1 are whole.
std::optional<int> read_integer(const Place& place, std::string_view what, IntegerRange range,
                                Findings& findings);

// A closed range of float32 numbers.
struct Float32Range {
  float low = 0;
  float high = 0;
};

// How to treat numbers that are no float32 numbers. `exact` refuses them, unless "~" requests the
// nearest, with a note. `nearest` takes the nearest, for inputs of rounded computations.
enum class Float32Kind { exact, nearest };

// A decimal or fraction (parse_float32), as a JSON number or a string, inside `range`.
std::optional<float> read_float32(const Place& place, std::string_view what, Float32Range range,
                                  Float32Kind kind, Findings& findings);

// Returns true if it is an array of `count` items; otherwise adds a finding.
bool expect_count(const Place& place, std::string_view what, std::size_t count, Findings& findings);

// An array of N such numbers.
template <std::size_t N>
std::optional<std::array<float, N>> read_float32s(const Place& place, std::string_view what,
                                                  Float32Range range, Float32Kind kind,
                                                  Findings& findings) {
  if (!expect_count(place, what, N, findings)) return std::nullopt;
  std::array<float, N> values{};
  bool sound = true;
  for (std::size_t i = 0; i < N; ++i) {
    const auto value =
        read_float32(place.child(i), "a number of " + std::string(what), range, kind, findings);
    values[i] = value.value_or(0);
    sound = sound && value.has_value();
  }
  if (!sound) return std::nullopt;
  return values;
}

constexpr float kMaxColor = 18446744073709551616.0F;  // 2^64: the largest magnitude of a component

// [r, g, b] or [r, g, b, a], each inside `range` and rounded to the nearest float32; alpha is 1 by
// default.
std::optional<Color> read_color(const Place& place, std::string_view what, Float32Range range,
                                Findings& findings);

// Numbers and colours in the form of case files.
JsonPiece integer_piece(int value);

// Red, green, blue and, unless it is 1, alpha.
JsonPiece color_piece(const std::array<float, 4>& color);

// A finite float32 number with all its digits; -0 is written as 0.
JsonPiece exact_piece(float value);
JsonPiece exact_list(std::span<const float> values);

// The definitions of coordinate, float32, color and the like in the schema.
Pieces number_schemas();

}  // namespace edgecase
