// SPDX-License-Identifier: MIT
//
// How large a JSON text is once it is parsed, told before it is: the library copies and prints
// values recursively, and a value takes several times the bytes of its text.
#pragma once

#include <cstddef>
#include <string_view>

namespace edgecase {

struct JsonSize {
  std::size_t levels = 0;  // the most arrays and objects within each other
  std::size_t values = 0;  // arrays, objects, and what commas separate
};

// Arrays and objects within each other; our own texts have about eight.
constexpr std::size_t kMostLevels = 100;

// For text that is no JSON, at least as many as the parser makes before it notices.
JsonSize size_of_json(std::string_view text);

}  // namespace edgecase
