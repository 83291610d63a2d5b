// SPDX-License-Identifier: MIT
//
// The catalogue: every rule, in the order in which a reader meets them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/cause.h"
#include "model/verdict.h"
#include "rules/rule.h"

namespace edgecase {

std::span<const Rule> all_rules();

const Rule& rule_of(RuleId id);  // not of none
// Null when no rule has that id.
const Rule* find_rule(std::string_view id);
// Null when the rule has no such alternative.
const Alternative* find_alternative(const Rule& rule, std::string_view name);
// The rule must have an alternative of that name.
AlternativeId alternative_id(RuleId rule, std::string_view name);
// Null where the rule itself is the cause.
const Alternative* alternative_of(AlternativeId id);

// "rule=alternative", or the rule alone; several joined by " + "; empty of no cause.
std::string text_of(AlternativeId id);
std::string text_of(const Cause& cause);
// What the text is of; nothing where it names what the catalogue does not have.
std::optional<Cause> parse_cause(std::string_view text);

// Does the specification leave open every alternative that a cause names? Not of no cause.
bool is_open_choice(const Cause& cause);

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
