// SPDX-License-Identifier: MIT
//
// Change search: which sets of alternatives are tried as the cause of what a renderer does, and in
// which order.
//
// A search has a list of changes and a test of what a choice yields. It tries single alternatives
// first, then pairs. These are of different rules, since a choice has one alternative of each, and
// come once. Its caller decides whether one that fits is enough, and which pairs are worth trying.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rules/choices.h"

namespace edgecase {

// Calls visit(i, j), i < j, with the places of every pair: first those of the first alternative.
template <class Visit>
void for_each_pair(std::span<const Change> changes, const Visit& visit) {
  for (std::size_t i = 0; i < changes.size(); ++i)
    for (std::size_t j = i + 1; j < changes.size(); ++j)
      if (changes[i].id.rule != changes[j].id.rule) visit(i, j);
}

// The alternatives of all these rules, one after another.
inline Changes joined(const std::vector<Changes>& rules) {
  Changes all;
  for (const Changes& rule : rules) all.insert(all.end(), rule.begin(), rule.end());
  return all;
}

// A set for every alternative of these rules.
inline std::vector<Changes> singles_of(const std::vector<Changes>& rules) {
  std::vector<Changes> sets;
  for (const Changes& rule : rules)
    for (const Change& change : rule) sets.push_back({change});
  return sets;
}

// A set for every pair: first those of the first two rules.
inline std::vector<Changes> pairs_of(const std::vector<Changes>& rules) {
  std::vector<Changes> sets;
  for (std::size_t i = 0; i < rules.size(); ++i)
    for (std::size_t j = i + 1; j < rules.size(); ++j)
      for (const Change& first : rules[i])
        for (const Change& second : rules[j]) sets.push_back({first, second});
  return sets;
}

// The first of these changes, or of these sets of changes, that fits; no cause if none does.
template <class Tried, class Fits>
Cause first_cause(const std::vector<Tried>& all, const Fits& fits) {
  for (const Tried& tried : all)
    if (fits(tried)) return cause_of(Changes{tried});
  return {};
}

}  // namespace edgecase
