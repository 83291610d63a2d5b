// SPDX-License-Identifier: MIT
//
// Reads the root of a case file: the words round the scene, then the scene, then the drawings.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "casefile/fields.h"
#include "model/case.h"

namespace edgecase {

// Whether a name has the form of a rule's id: words of a-z, 0-9 and, after the first, '-', joined
// by dots, two words at least: "line.diamond-exit".
bool is_rule_id(std::string_view name);

// Fills `result` from the tree; its id and file must be set. What is wrong is added to `findings`,
// and `result` is then incomplete.
void read_case(const JsonNode& root, std::span<const std::string> known_rules, Findings& findings,
               Case& result);

}  // namespace edgecase
