// SPDX-License-Identifier: MIT
//
// Numbers of a case file: exact coordinates, whole numbers and colours. All are judged by their
// digits as written, never by a double that has rounded them already.
#pragma once

#include <optional>
#include <string_view>

#include "casefile/fields.h"
#include "exact/fixed.h"
#include "model/scene.h"

namespace edgecase {

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

// [r, g, b] or [r, g, b, a], each 0 to 1 and taken to the nearest float32; alpha is 1 if not said.
std::optional<Color> read_color(const Place& place, std::string_view what, Findings& findings);

}  // namespace edgecase
