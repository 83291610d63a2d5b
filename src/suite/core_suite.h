// SPDX-License-Identifier: MIT
//
// The core of a suite: a short list of cases that tells apart whatever the whole suite tells apart.
//
// Slow programs, phones and people in a hurry are asked these first. What the list must reach are
// goals: each pair of a rule's alternatives that some case tells apart (suite/separation.h), and
// each rule with a ruling in force that some case names. Finding the shortest list is the set cover
// problem, so the list is found greedily, and a lower bound of its length says how much shorter
// another could be.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "results/results.h"
#include "suite/case_store.h"

namespace edgecase {

struct CoreSuite {
  std::vector<std::string> ids;      // sorted
  std::size_t pairs = 0;             // of alternatives that the suite tells apart
  std::size_t rules = 0;             // with rulings, that the suite names
  std::size_t fewest = 0;            // no list that reaches the goals is shorter
  std::vector<std::string> unnamed;  // rules with rulings in force that no case names
};

// `times`: by how many cases each goal is reached, or by all that reach it if those are fewer; at
// least 1. Cases of large targets are taken for goals that no other reaches; of those that reach
// equally many, the one of the smallest weight is taken.
CoreSuite find_core(const CaseStore& cases, std::size_t times);

// Appends to a sorted list of ids, for each renderer of the results, the first case that shows each
// of its known faults, and the first that is a violation of one without any: unless the list has
// such a case. Returns how many were added. The list stays sorted.
std::size_t add_shown(const Results& results, std::vector<std::string>& ids);

}  // namespace edgecase
