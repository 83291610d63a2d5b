// SPDX-License-Identifier: MIT
//
// Integers of a JSON text. The library converts any number to any integer: 1.5 to 1, -1 to a count
// of 2^64 - 1, and 1e300 to nothing that C++ defines.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <utility>

#include "results/shallow_json.h"

namespace edgecase {

// A JSON value that becomes the integer to which it is assigned. Throws std::runtime_error where it
// is none, was not written as one, or is out of the type's range.
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
