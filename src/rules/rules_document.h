// SPDX-License-Identifier: MIT
//
// The catalogue as one document: this returns the text of src/rules/RULINGS.md, and a test compares
// the two.
#pragma once

#include <string>

namespace edgecase {

// Markdown in GitHub's dialect: all rulings in the order of their numbers, then every rule with its
// section of the specification, its latitude and its alternatives, in the order of all_rules.
std::string rules_document();

}  // namespace edgecase
