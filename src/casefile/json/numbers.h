// SPDX-License-Identifier: MIT
//
// Numbers of a case file: exact coordinates, whole numbers and colours. All are judged by their
// digits as written, never by a double that has rounded them already.
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

// Characters of a number that is written as a string, at most, as editors are told: of a
// coordinate, and of a float32 number with all its digits.
constexpr int kMostNumeralCharacters = 64;
constexpr int kMostCharacters = 200;

// A closed range of exact numbers.
struct FixedRange {
  Fixed low;
  Fixed high;
};

// An exact numeral, as a JSON number or a string (see exact/numeral.h), inside `range`. A "~"
// numeral leaves a note that says which number was taken.
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

// What becomes of a number that is no float32 number: it is refused, unless "~" asks for the
// nearest, which leaves a note; or the nearest is taken, as for all that is computed with anyway.
enum class Float32Kind { exact, nearest };

// A decimal or fraction (casefile/json/float32.h), as a JSON number or a string, inside `range`.
std::optional<float> read_float32(const Place& place, std::string_view what, Float32Range range,
                                  Float32Kind kind, Findings& findings);

// Is it an array of so many items? Adds a finding otherwise.
bool expect_count(const Place& place, std::string_view what, std::size_t count, Findings& findings);

// N of them in an array.
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

constexpr float kMaxColor = 18446744073709551616.0F;  // 2^64: a component's largest magnitude

// [r, g, b] or [r, g, b, a], each inside `range` and taken to the nearest float32; alpha is 1 if
// not said.
std::optional<Color> read_color(const Place& place, std::string_view what, Float32Range range,
                                Findings& findings);

// Numbers and colours as a case file has them.
JsonPiece integer_piece(int value);

// A colour's component: the shortest decimal whose nearest float32 it is; -0 is written as 0.
JsonPiece component_piece(float value);

// Red, green, blue and, where it is not 1, alpha.
JsonPiece color_piece(const std::array<float, 4>& color);

// A finite float32 number with all its digits; -0 is written as 0.
JsonPiece exact_piece(float value);
JsonPiece exact_list(std::span<const float> values);

// Their definitions in the schema: coordinate, float32, color and the like.
Pieces number_schemas();

}  // namespace edgecase
