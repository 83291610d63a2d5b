// SPDX-License-Identifier: MIT
//
// The cause of values that one rule alone decides.
#pragma once

#include <span>
#include <string>

namespace edgecase {

// "rule=alternative" of the first alternative beside the chosen one that yields all there is;
// empty: none does.
template <class Choice, class Yields>
std::string cause_among(std::span<const Choice> all, Choice chosen, const char* rule,
                        const Yields& yields) {
  for (const Choice choice : all)
    if (choice != chosen && yields(choice)) return std::string(rule) + "=" + name_of(choice);
  return "";
}

}  // namespace edgecase
