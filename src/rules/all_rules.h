// SPDX-License-Identifier: MIT
//
// The catalogue: every rule, in the order in which a reader meets them.
#pragma once

#include <span>
#include <string_view>

#include "rules/rule.h"

namespace edgecase {

std::span<const Rule> all_rules();

// Null when no rule has that id.
const Rule* find_rule(std::string_view id);
// Null when the rule has no such alternative.
const Alternative* find_alternative(const Rule& rule, std::string_view name);
// Null when no rule has a ruling of that number.
const Ruling* find_ruling(int number);

}  // namespace edgecase
