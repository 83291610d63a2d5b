// SPDX-License-Identifier: MIT
//
// Reads JSON from foreign files, with limits on its nesting and on its values (wire/json_size.h).
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "model/names.h"
#include "wire/json_size.h"

namespace edgecase {

// Of objects that are read, members in any order; what is written keeps its own (ordered_json).
using ReadJson = nlohmann::json;

// Both throw std::runtime_error for text that is nested deeper than kMostLevels, and what the
// library throws for text that is no JSON; of a whole document also for more than 2^20 values.
ReadJson parse_shallow(std::string_view text);
ReadJson parse_line(std::string_view text);

// A string's text. Throws std::runtime_error for any other value.
std::string_view to_text(const ReadJson& json);

// The value with this name. Throws std::runtime_error if there is none, and what the library throws
// for JSON that is no text.
[[noreturn]] void refuse_name(const std::string& name);
std::string name_in(const ReadJson& json);
template <HasNames Enum>
Enum to_named(const ReadJson& json) {
  Enum value{};
  const std::string name = name_in(json);
  if (!parse_name(name, value)) refuse_name(name);
  return value;
}

// An exception's sentence, without the tag in brackets that the JSON library puts before it.
std::string fault_of(const std::exception& error);

// Integers of a JSON text. The library converts any number to any integer: 1.5 to 1, -1 to a count
// of 2^64 - 1, and 1e300 to nothing that C++ defines.

// A JSON value that converts to the integer to which it is assigned. Throws std::runtime_error if
// it is no integer, was not written as one, or is out of the type's range.
class WholeNumber {
 public:
  explicit WholeNumber(const ReadJson& json) : json_(json) {}

  template <std::integral Integer>
  requires(!std::same_as<Integer, bool>) operator Integer()
      const {  // NOLINT(google-explicit-constructor)
    if (const auto n = natural(); n && std::in_range<Integer>(*n)) return static_cast<Integer>(*n);
    if (const auto n = negative(); n && std::in_range<Integer>(*n)) return static_cast<Integer>(*n);
    refuse();
  }

 private:
  std::optional<std::uint64_t> natural() const;  // 0 and more
  std::optional<std::int64_t> negative() const;  // below 0
  [[noreturn]] void refuse() const;

  const ReadJson& json_;
};

}  // namespace edgecase
