// SPDX-License-Identifier: MIT
#include "results/whole_number.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace edgecase {

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
