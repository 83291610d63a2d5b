// SPDX-License-Identifier: MIT
//
// A rule's alternatives in one table beside the enumeration that stands for them (model/names.h):
// the name that policies use, whether it conforms, and what it means.
#pragma once

#include <array>
#include <vector>

#include "model/names.h"
#include "rules/rule.h"

namespace edgecase {

template <class Enum>
struct TabledAlternative {
  Enum value;
  const char* name;
  Openness openness;
  const char* meaning;
};

template <HasNames Enum>
std::vector<Alternative> alternatives_of() {
  std::vector<Alternative> alternatives;
  for (const auto& row : kNames<Enum>)
    alternatives.push_back({row.name, row.openness, row.meaning});
  return alternatives;
}

}  // namespace edgecase
