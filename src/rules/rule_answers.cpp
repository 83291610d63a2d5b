// SPDX-License-Identifier: MIT
#include "rules/rule_answers.h"

#include <algorithm>
#include <set>

#include "rules/all_rules.h"

namespace edgecase {
namespace {

// If single alternatives of one rule are among the causes, adds all others of that rule: what was
// drawn is drawn by none of them. Where rules vie for it, neither is told.
void add_others(const std::vector<Cause>& causes, AlternativeSet& against) {
  std::set<AlternativeId> singles;
  for (const Cause& cause : causes)
    if (cause.size() == 1) singles.insert(cause.parts.front());
  if (singles.empty() || singles.begin()->rule != singles.rbegin()->rule) return;
  const RuleId rule = singles.begin()->rule;
  for (std::size_t i = 0; i < rule_of(rule).alternatives.size(); ++i)
    if (const AlternativeId id{rule, static_cast<std::uint8_t>(i)}; !singles.contains(id))
      against.add(id);
}

}  // namespace

std::string remaining_of(const RuleAnswers& answers) {
  const std::size_t least = *std::ranges::min_element(answers.against);
  if (10 * (answers.asked - least) < 9 * answers.asked) return kNoneKnown;
  std::string names;
  for (std::size_t i = 0; i < answers.against.size(); ++i)
    if (answers.against[i] == least)
      names += (names.empty() ? "" : " or ") + rule_of(answers.rule).alternatives[i].name;
  return names;
}

std::vector<std::pair<std::string, std::size_t>> names_spoken_for(const RuleAnswers& answers) {
  std::vector<std::pair<std::string, std::size_t>> names;
  for (std::size_t i = 0; i < answers.against.size(); ++i)
    if (answers.against[i] < answers.asked)
      names.emplace_back(rule_of(answers.rule).alternatives[i].name, answers.speaking_for(i));
  return names;
}

AlternativeSet contradicted_by(const Result& result) {
  AlternativeSet against = result.refuted;
  for (const Result::Evidence& evidence : result.evidence) add_others(evidence.causes, against);
  return against;
}

void RuleAnswersGatherer::add(const AlternativeSet& against) {
  RuleId latest = RuleId::none;
  against.for_each([&](AlternativeId id) {
    const auto rule = static_cast<std::size_t>(id.rule);
    ++against_[rule][id.index];
    if (id.rule != latest) ++asked_[rule];
    latest = id.rule;
  });
}

std::vector<RuleAnswers> RuleAnswersGatherer::answers() const {
  std::vector<RuleAnswers> all;
  for (const Rule& rule : all_rules()) {
    const auto index = static_cast<std::size_t>(rule.id);
    if (asked_[index] == 0 || rule.alternatives.empty()) continue;
    const auto first = against_[index].begin();
    const auto count = static_cast<std::ptrdiff_t>(rule.alternatives.size());
    all.push_back({rule.id, asked_[index], {first, first + count}});
  }
  return all;
}

}  // namespace edgecase
