// SPDX-License-Identifier: MIT
//
// Tallies of the alternatives that the catalogue has of one rule.
#pragma once

#include <string>
#include <vector>

#include "model/policy.h"
#include "profile/tally.h"

namespace edgecase {

// Whether each of a number of facts is as an alternative has it.
using Facts = std::vector<bool>;

// In the catalogue's order; the rule must be of the catalogue.
std::vector<std::string> names_of_alternatives(const std::string& rule);

// Of all alternatives, the rule's standard one preferred.
Tally tally_of(const std::string& rule);

// facts[a][i]: does alternative a yield fact i? As many of each alternative.
void add_all(Tally& tally, const std::vector<Facts>& facts);

// The rules found so far, one of them chosen otherwise.
Policy policy_with(const Choices& found, const std::string& rule, const std::string& alternative);

}  // namespace edgecase
