// SPDX-License-Identifier: MIT
//
// Reads objects whose keys are rules: choices of alternatives, and words on rules.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "casefile/json/fields.h"
#include "model/case.h"
#include "model/policy.h"

namespace edgecase {

struct KnownRule {
  std::string id;
  std::vector<std::string> alternatives;
  std::string title = {};  // what the rule says, for people
};

// Whether a member's key is the id of a rule, of a known one where any are; adds a finding
// otherwise.
bool check_rule_id(const Place& place, std::span<const KnownRule> known, Findings& findings);

// {"RULE": "ALTERNATIVE", ...}. `known`: every rule that may be named, with its alternatives;
// empty: not checked.
Choices read_choices(const Place& place, std::span<const KnownRule> known, Findings& findings);

// Loads a policy file: a choice of alternative for rules, over all and per kind of surface.
//
//   {"name": "mine", "latitude": "none", "rules": {"triangle.fill-rule": "left-bottom"},
//    "surfaces": {"fbo": {"line.snap": "none"}}}
//
// `name` is required; latitude is "opengl" if not said; "$schema" and "why" (a string for people)
// are allowed too. Faults are collected as for cases. What rules and alternatives exist is the
// caller's knowledge.
struct LoadedPolicy {
  std::optional<Policy> value;  // set exactly when there are no diagnostics
  std::vector<Diagnostic> diagnostics;
};

// `known`: every rule that may be named, with its alternatives; empty: not checked.
LoadedPolicy load_policy(const std::filesystem::path& file, std::span<const KnownRule> known);

LoadedPolicy load_policy_text(const std::string& text, const std::filesystem::path& file,
                              std::span<const KnownRule> known);

// The text of cases/policy.schema.json, by which editors help and check: the rules of `known` that
// have alternatives, each with their names.
std::string policy_schema(std::span<const KnownRule> known);

}  // namespace edgecase
