// SPDX-License-Identifier: MIT
#include "profile/rule_tally.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "rules/all_rules.h"

namespace edgecase {

std::vector<std::string> names_of_alternatives(const std::string& rule) {
  std::vector<std::string> names;
  for (const Alternative& alternative : find_rule(rule)->alternatives)
    names.push_back(alternative.name);
  return names;
}

Tally tally_of(const std::string& rule) {
  std::vector<std::string> names = names_of_alternatives(rule);
  const auto standard = std::find(names.begin(), names.end(), find_rule(rule)->standard);
  const auto index = static_cast<std::size_t>(standard - names.begin());
  return {std::move(names), index};
}

void add_all(Tally& tally, const std::vector<Facts>& facts) {
  for (std::size_t i = 0; i < facts.front().size(); ++i) {
    std::vector<bool> yields;
    for (const Facts& alternative : facts) yields.push_back(alternative[i]);
    tally.add(yields);
  }
}

Policy policy_with(const Choices& found, const std::string& rule, const std::string& alternative) {
  Policy policy;
  policy.rules = found;
  policy.rules[rule] = alternative;
  return policy;
}

}  // namespace edgecase
