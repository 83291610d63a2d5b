// SPDX-License-Identifier: MIT
#include "results/shallow_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace edgecase {
namespace {

void check_shallow(std::string_view text, std::size_t most_values) {
  // The parser would stop at a NUL.
  if (const auto nul = text.find('\0'); nul != text.npos)
    throw std::runtime_error(fmt::format("byte {} is NUL, which no JSON holds", nul));
  const JsonSize size = size_of_json(text);
  if (size.levels > kMostLevels)
    throw std::runtime_error(fmt::format("it is nested deeper than {} levels", kMostLevels));
  if (size.values > most_values)
    throw std::runtime_error(fmt::format("it holds more than {} values", most_values));
}

}  // namespace

ReadJson parse_shallow(std::string_view text) {
  // Of a decision on each case of the suite, several times over. Each value may take 100 bytes.
  constexpr std::size_t kMostValues = std::size_t{1} << 20;
  check_shallow(text, kMostValues);
  return ReadJson::parse(text);
}

ReadJson parse_line(std::string_view text) {
  check_shallow(text, text.size());
  return ReadJson::parse(text);
}

std::string_view to_text(const ReadJson& json) {
  if (!json.is_string()) throw std::runtime_error("a text is missing");
  return json.get_ref<const std::string&>();
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
  const std::string text = json_.is_structured() ? json_.type_name() : json_.dump();
  constexpr std::size_t kMost = 60;  // characters that are quoted
  throw std::runtime_error(fmt::format("{} is no whole number in range", text.substr(0, kMost)));
}

}  // namespace edgecase
