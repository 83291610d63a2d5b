// SPDX-License-Identifier: MIT
//
// Names: how case files, JSON and reports write the values of an enumeration. They are in one table
// beside the enumeration, in the order in which people read them:
//
//   enum class Filter { nearest, linear };
//   template <>
//   inline constexpr auto kNames<Filter> =
//       std::to_array<Named<Filter>>({{Filter::nearest, "nearest"}, {Filter::linear, "linear"}});
//
// A row may have further members, as a rule's alternatives do.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace edgecase {

template <class Enum>
struct Named {
  Enum value;
  const char* name;
};

// The primary template, for enumerations without names.
template <class Enum>
inline constexpr int kNames = 0;

template <class Enum>
concept HasNames = std::is_enum_v<Enum> && requires {
  kNames<Enum>.begin()->name;
};

// "?" if the table lacks the value.
template <HasNames Enum>
constexpr const char* name_of(Enum value) {
  for (const auto& row : kNames<Enum>)
    if (row.value == value) return row.name;
  return "?";
}

// The inverse of name_of: returns false, and leaves `value` unchanged, if there is no such name.
template <HasNames Enum>
constexpr bool parse_name(std::string_view name, Enum& value) {
  for (const auto& row : kNames<Enum>) {
    if (name != row.name) continue;
    value = row.value;
    return true;
  }
  return false;
}

template <HasNames Enum>
inline constexpr auto kValues = [] {
  std::array<Enum, kNames<Enum>.size()> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = kNames<Enum>[i].value;
  return values;
}();

// All values, in the table's order.
template <HasNames Enum>
constexpr std::span<const Enum> values_of() {
  return kValues<Enum>;
}

// All names, in the table's order.
template <HasNames Enum>
std::vector<std::string> names_of() {
  std::vector<std::string> names;
  for (const auto& row : kNames<Enum>) names.emplace_back(row.name);
  return names;
}

}  // namespace edgecase
