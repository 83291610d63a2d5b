// SPDX-License-Identifier: MIT
//
// Tables of a rule's alternatives, each with the enumeration's value that stands for it: one place
// for the name that policies use, what it means, and whether it conforms.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "rules/rule.h"

namespace edgecase {

template <class Enum>
struct TabledAlternative {
  Enum value;
  const char* name;
  Openness openness;
  const char* meaning;
};

// "?" where the table has no such value.
template <class Enum, std::size_t N>
const char* name_in(const TabledAlternative<Enum> (&table)[N], Enum value) {
  for (const auto& row : table)
    if (row.value == value) return row.name;
  return "?";
}

// False where the table has no such name; `value` is then untouched.
template <class Enum, std::size_t N>
bool find_in(const TabledAlternative<Enum> (&table)[N], std::string_view name, Enum& value) {
  for (const auto& row : table) {
    if (name != row.name) continue;
    value = row.value;
    return true;
  }
  return false;
}

template <class Enum, std::size_t N>
constexpr std::array<Enum, N> values_in(const TabledAlternative<Enum> (&table)[N]) {
  std::array<Enum, N> values{};
  for (std::size_t i = 0; i < N; ++i) values[i] = table[i].value;
  return values;
}

template <class Enum, std::size_t N>
std::vector<Alternative> alternatives_in(const TabledAlternative<Enum> (&table)[N]) {
  std::vector<Alternative> alternatives;
  for (const auto& row : table) alternatives.push_back({row.name, row.openness, row.meaning});
  return alternatives;
}

}  // namespace edgecase
