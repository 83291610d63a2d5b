// SPDX-License-Identifier: MIT
//
// Reads objects whose keys are rules: choices of alternatives, and words on rules.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "casefile/fields.h"
#include "model/policy.h"

namespace edgecase {

struct KnownRule {
  std::string id;
  std::vector<std::string> alternatives;
};

// Whether a member's key is the id of a rule, of a known one where any are; adds a finding
// otherwise.
bool check_rule_id(const Place& place, std::span<const KnownRule> known, Findings& findings);

// {"RULE": "ALTERNATIVE", ...}. `known`: every rule that may be named, with its alternatives;
// empty: not checked.
Choices read_choices(const Place& place, std::span<const KnownRule> known, Findings& findings);

}  // namespace edgecase
