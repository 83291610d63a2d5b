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

// The largest number of open arrays and objects in a text. For text that is no JSON, at least as
// many as the parser opens before it notices.
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
  // The parser would stop at a NUL.
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

void refuse_name(const std::string& name) {
  throw std::runtime_error(fmt::format("\"{}\" is not known here", name));
}

std::string name_in(const ReadJson& json) {
  return json.get<std::string>();
}

std::string fault_of(const std::exception& error) {
  constexpr std::string_view kTag = "[json.exception.";
  const std::string_view text = error.what();
  const std::size_t end = text.starts_with(kTag) ? text.find("] ") : text.npos;
  return std::string(end == text.npos ? text : text.substr(end + 2));
}

std::optional<std::uint64_t> WholeNumber::natural() const {
  if (json_.is_number_unsigned()) return json_.get<std::uint64_t>();
  // The library keeps what a program puts in as signed, and what it parses as unsigned.
  if (json_.is_number_integer() && json_.get<std::int64_t>() >= 0)
    return static_cast<std::uint64_t>(json_.get<std::int64_t>());
  return std::nullopt;
}

std::optional<std::int64_t> WholeNumber::negative() const {
  if (json_.is_number_unsigned() || !json_.is_number_integer()) return std::nullopt;
  const auto number = json_.get<std::int64_t>();
  return number < 0 ? std::optional(number) : std::nullopt;
}

void WholeNumber::refuse() const {
  const std::string text(json_.is_structured() ? ReadText(json_.type_name()) : json_.dump());
  constexpr std::size_t kMost = 60;  // characters that are quoted
  throw std::runtime_error(fmt::format("{} is no whole number in range", text.substr(0, kMost)));
}

}  // namespace edgecase
