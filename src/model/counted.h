// SPDX-License-Identifier: MIT
//
// Numbers with their nouns, as text for people.
#pragma once

#include <cstddef>
#include <string>

namespace edgecase {

// Digits in groups of three: "30,718".
inline std::string grouped(std::size_t count) {
  std::string text = std::to_string(count);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, 1, ',');
  return text;
}

// "1 case", "30,718 cases".
inline std::string counted(std::size_t count, const char* one, const char* several) {
  return grouped(count) + " " + (count == 1 ? one : several);
}

}  // namespace edgecase
