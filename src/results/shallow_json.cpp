// SPDX-License-Identifier: MIT
#include "results/shallow_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

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

// The most arrays and objects of a text that are open at once. Of text that is no JSON, at least
// as many as the parser opens before it finds out.
std::size_t levels_of(std::string_view text) {
  std::size_t open = 0;
  std::size_t most = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"') {
      i = end_of_string(text, i);
      continue;
    }
    if (c == '[' || c == '{') most = std::max(most, ++open);
    if ((c == ']' || c == '}') && open > 0) --open;
    ++i;
  }
  return most;
}

void check_shallow(std::string_view text) {
  // The parser would take it for the end of the text.
  if (const auto nul = text.find('\0'); nul != text.npos)
    throw std::runtime_error(fmt::format("byte {} is NUL, which no JSON holds", nul));
  if (levels_of(text) > kMostLevels)
    throw std::runtime_error(fmt::format("it is nested deeper than {} levels", kMostLevels));
}

}  // namespace

nlohmann::json parse_shallow(std::string_view text) {
  check_shallow(text);
  return nlohmann::json::parse(text);
}

ReadJson parse_line(std::string_view text) {
  check_shallow(text);
  return ReadJson::parse(text);
}

std::string_view to_text(const ReadJson& json) {
  if (!json.is_string()) throw std::runtime_error("a text is missing");
  return json.get_ref<const ReadText&>();
}

std::string fault_of(const std::exception& error) {
  constexpr std::string_view kTag = "[json.exception.";
  const std::string_view text = error.what();
  const std::size_t end = text.starts_with(kTag) ? text.find("] ") : text.npos;
  return std::string(end == text.npos ? text : text.substr(end + 2));
}

}  // namespace edgecase
