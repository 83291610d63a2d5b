// SPDX-License-Identifier: MIT
//
// The cause of values that one rule alone decides.
#pragma once

#include <span>

#include "rules/all_rules.h"

namespace edgecase {

// The first alternative beside the chosen one that yields all there is; no cause where none does.
template <class Choice, class Yields>
Cause cause_among(std::span<const Choice> all, Choice chosen, RuleId rule, const Yields& yields) {
  for (const Choice choice : all)
    if (choice != chosen && yields(choice)) return alternative_id(rule, name_of(choice));
  return {};
}

}  // namespace edgecase
