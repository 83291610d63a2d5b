// SPDX-License-Identifier: MIT
//
// The catalogue: every rule, in the order in which a reader meets them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/policy.h"
#include "model/verdict.h"
#include "rules/rule.h"

namespace edgecase {

std::span<const Rule> all_rules();

const Rule& rule_of(RuleId id);  // any rule but none
// Null if no rule has that id.
const Rule* find_rule(std::string_view id);
// Null if the rule has no such alternative.
const Alternative* find_alternative(const Rule& rule, std::string_view name);
// The rule must have an alternative of that name.
AlternativeId alternative_id(RuleId rule, std::string_view name);
// Null if the rule itself is the cause.
const Alternative* alternative_of(AlternativeId id);

// "rule=alternative", or the rule alone; several joined by " + "; empty for no cause.
std::string text_of(AlternativeId id);
std::string text_of(const Cause& cause);
// The cause that the text names; none if it names something that the catalogue does not have.
std::optional<Cause> parse_cause(std::string_view text);

// True if the specification leaves open every alternative of the cause; false for no cause.
bool is_open_choice(const Cause& cause);

// The catalogue as readers of policies know it.
std::vector<KnownRule> known_rules();

// Null if no rule has a ruling of that number.
const Ruling* find_ruling(int number);

// The facts about a ruling besides its text, in the order for readers: "Basis", "Text" with
// revision, clause and quotation, "Conformance tests", "OpenGL ES", "Withdrawn". Unknown facts are
// left out.
struct RulingFact {
  std::string name;
  std::string text;  // without a full stop at its end
};
std::vector<RulingFact> facts_of(const Ruling& ruling);

// The legality of a difference that the letter of a ruling forbids: contested if the ruling's basis
// is, else illegal. For a number without a ruling, illegal.
Legality legality_against(int ruling);

}  // namespace edgecase
