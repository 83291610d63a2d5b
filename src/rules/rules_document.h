// SPDX-License-Identifier: MIT
//
// The catalogue as one document: src/rules/RULINGS.md is what this returns, and a test holds the
// two together.
#pragma once

#include <string>

namespace edgecase {

// Markdown, as GitHub reads it: all rulings in the order of their numbers, then every rule with its
// section of the specification, its latitude and its alternatives, in the order of all_rules.
std::string rules_document();

}  // namespace edgecase
