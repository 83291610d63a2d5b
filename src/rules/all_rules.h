// SPDX-License-Identifier: MIT
//
// The catalogue: every rule, in the order in which a reader meets them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/verdict.h"
#include "rules/rule.h"

namespace edgecase {

std::span<const Rule> all_rules();

// Null when no rule has that id.
const Rule* find_rule(std::string_view id);
// Null when the rule has no such alternative.
const Alternative* find_alternative(const Rule& rule, std::string_view name);
// Null when no rule has a ruling of that number.
const Ruling* find_ruling(int number);

// What is known of a ruling beside its text, in the order in which people read it: "Basis", "Text"
// with revision, clause and quotation, "Conformance tests", "OpenGL ES", "Withdrawn". What is not
// known is left out.
struct RulingFact {
  std::string name;
  std::string text;  // without a full stop at its end
};
std::vector<RulingFact> facts_of(const Ruling& ruling);

// What a difference is that the letter of a ruling forbids: contested where the ruling's basis is,
// else illegal. Of a number that no ruling has, illegal.
Legality legality_against(int ruling);

}  // namespace edgecase
