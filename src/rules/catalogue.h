// SPDX-License-Identifier: MIT
//
// The table of contents: every rule, where its choice is kept, and in what it has a say. An
// explicit list: nothing registers itself. rules/all_rules.h has it complete.
#pragma once

#include <vector>

#include "rules/rule.h"

namespace edgecase {

// Without what rulings rest on.
std::vector<Rule> table_of_contents();

}  // namespace edgecase
