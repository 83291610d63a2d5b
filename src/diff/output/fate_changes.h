// SPDX-License-Identifier: MIT
//
// Alternatives of the rules that lie between a fragment and the target, as changes of a choice, to
// try one after another.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "diff/output/arrivals.h"

namespace edgecase {

struct FateChange {
  std::string rule;
  std::string cause;  // "rule=alternative"
  std::function<void(FateChoice&)> apply;

  FateChoice applied_to(FateChoice choice) const {
    apply(choice);
    return choice;
  }
};

// All alternatives of the rules that have a say in what becomes of a scene's fragments, beside what
// is chosen.
std::vector<FateChange> fate_changes_beside(const FateChoice& chosen, const Scene& scene);

// Of one rule.
std::vector<FateChange> fate_changes_of(const std::string& rule, const FateChoice& chosen,
                                        const Scene& scene);

// The ruling by which what breaks the rule is judged; 0 where nothing is open.
int ruling_on_fate(const std::string& rule);

}  // namespace edgecase
