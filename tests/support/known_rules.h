// SPDX-License-Identifier: MIT
//
// The catalogue as readers of policies know it.
#pragma once

#include <vector>

#include "casefile/policy_reader.h"
#include "rules/all_rules.h"

namespace edgecase {

inline std::vector<KnownRule> known_rules() {
  std::vector<KnownRule> known;
  for (const Rule& rule : all_rules()) {
    known.push_back({name_of(rule.id), {}, rule.title});
    for (const Alternative& alternative : rule.alternatives)
      known.back().alternatives.push_back(alternative.name);
  }
  return known;
}

}  // namespace edgecase
