// SPDX-License-Identifier: MIT
//
// Tables of the names that case files, JSON and reports use for the values of an enumeration.
#pragma once

#include <cstddef>
#include <string>

namespace edgecase {

template <class Enum>
struct Named {
  Enum value;
  const char* name;
};

// "?" where the table has no such value.
template <class Enum, std::size_t N>
const char* find_name(const Named<Enum> (&table)[N], Enum value) {
  for (const auto& row : table)
    if (row.value == value) return row.name;
  return "?";
}

// False where the table has no such name; `value` is then untouched.
template <class Enum, std::size_t N>
bool find_value(const Named<Enum> (&table)[N], const std::string& name, Enum& value) {
  for (const auto& row : table) {
    if (name != row.name) continue;
    value = row.value;
    return true;
  }
  return false;
}

}  // namespace edgecase
