// SPDX-License-Identifier: MIT
//
// Rounds of planted alternatives. Each plants alternatives of several rules that do not hide each
// other, and one measurement must find all of them: a measurement for each alternative would take
// many times as long.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "model/policy.h"
#include "profile/evidence/inference.h"
#include "rules/all_rules.h"
#include "tests/support/share.h"

namespace edgecase {

struct PlantedRound {
  Choices rules;
  std::vector<std::string> hidden;  // rules of which nothing tells under these
};

// The policy's own rules and those of `standard` that it leaves alone, but for the hidden ones.
inline Choices rules_to_find(const PlantedRound& round, const Choices& standard) {
  Choices rules = round.rules;
  rules.insert(standard.begin(), standard.end());
  for (const std::string& rule : round.hidden) rules.erase(rule);
  return rules;
}

// Do the rounds find each alternative of each rule of `standard`, which is what they leave alone?
inline void expect_each_planted(const std::vector<PlantedRound>& rounds, const Choices& standard) {
  for (const auto& [rule, own] : standard)
    for (const std::string& name : names_of_alternatives(find_rule(rule)->id)) {
      const auto finds = [&, id = rule](const PlantedRound& round) {
        const Choices rules = rules_to_find(round, standard);
        const auto found = rules.find(id);
        return found != rules.end() && found->second == name;
      };
      EXPECT_TRUE(std::any_of(rounds.begin(), rounds.end(), finds)) << rule << "=" << name;
    }
}

}  // namespace edgecase
