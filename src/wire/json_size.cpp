// SPDX-License-Identifier: MIT
#include "wire/json_size.h"

#include <algorithm>

namespace edgecase {
namespace {

// Behind the string that begins at `begin`; the text's size where it does not end.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
  for (std::size_t at = text.find('"', begin + 1); at != text.npos; at = text.find('"', at + 1)) {
    // A quote is escaped by an odd number of backslashes. The opening quote ends their row.
    const std::size_t before = text.find_last_not_of('\\', at - 1);
    if ((at - before) % 2 == 1) return at + 1;
  }
  return text.size();
}

}  // namespace

JsonSize size_of_json(std::string_view text) {
  JsonSize size;
  std::size_t open = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"') {
      i = end_of_string(text, i);
      continue;
    }
    const bool opens = c == '[' || c == '{';
    if (opens) size.levels = std::max(size.levels, ++open);
    if (opens || c == ',') ++size.values;
    if ((c == ']' || c == '}') && open > 0) --open;
    ++i;
  }
  return size;
}

}  // namespace edgecase
