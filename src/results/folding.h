// SPDX-License-Identifier: MIT
//
// Folding: how the results file keeps what is long.
//
// A picture of 512 by 512 pixels is two megabytes of digits, and a list of all places where it
// differs as many again. Nothing of that is left out, but of cases with more than kMostPixels
// pixels JSON of more than kLongest characters stands deflated (RFC 1950) in its place, as the
// string "zlib:" and base 64, and long lists of places as runs. The results of smaller cases can be
// read without any of this.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "model/verdict.h"
#include "results/json_writer.h"

namespace edgecase {

constexpr std::size_t kMostPixels = 8192;
constexpr std::size_t kLongest = 65536;

// Folds the JSON value with which `text` ends, from `first` on, where that is longer. A string that
// begins with "zlib:" is not taken.
void fold(std::string& text, std::size_t first);

// What was folded, or the same where it was not. Throws std::runtime_error for a fold that is
// damaged.
nlohmann::json unfolded(const nlohmann::json& json);

// Writes places as a list of [x, y, primitive]. More than kMostPlaces, where they are sorted by
// row, column and primitive, as runs [x, y, primitive, count] of neighbours in a row, sorted by
// primitive, row and column. Each place stands once, or the list stays as it is.
constexpr std::size_t kMostPlaces = 1000;
void write_places(JsonWriter& json, const std::vector<ValueAggregate::Place>& places);

// The inverse. Throws std::runtime_error for anything else.
std::vector<ValueAggregate::Place> to_places(const nlohmann::json& json);

}  // namespace edgecase
