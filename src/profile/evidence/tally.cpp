// SPDX-License-Identifier: MIT
#include "profile/evidence/tally.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "rules/all_rules.h"

namespace edgecase {

double Rate::share() const {
  return of == 0 ? 1 : static_cast<double>(agreeing) / static_cast<double>(of);
}

std::string percent(const Rate& rate) {
  if (rate.of == 0) return "-";
  if (rate.agreeing == rate.of) return "100 %";
  const std::size_t hundredths = rate.agreeing * 10'000 / rate.of;
  return fmt::format("{}.{:02} %", hundredths / 100, hundredths % 100);
}

std::string text_of(const TraitId& id) {
  if (id.rule == RuleId::none) return id.probe;
  return id.probe.empty() ? name_of(id.rule) : fmt::format("{}:{}", name_of(id.rule), id.probe);
}

void OwnershipTable::Cell::count(bool is_drawn) {
  ++of;
  if (is_drawn) ++drawn;
}

OwnershipTable::OwnershipTable(std::string table_title, std::vector<std::string> row_names,
                               std::vector<std::string> column_names)
    : title(std::move(table_title)),
      rows(std::move(row_names)),
      columns(std::move(column_names)),
      cells(rows.size(), std::vector<Cell>(columns.size())) {}

std::vector<std::string> names_of_alternatives(RuleId rule) {
  std::vector<std::string> names;
  for (const Alternative& alternative : rule_of(rule).alternatives)
    names.push_back(alternative.name);
  return names;
}

RuleChoices with_alternative(RuleChoices choices, RuleId rule, const std::string& alternative) {
  rule_of(rule).slot.put(choices, alternative);
  return choices;
}

std::vector<RuleChoices> choices_by_alternative(const RuleChoices& choices, RuleId rule) {
  std::vector<RuleChoices> result;
  for (const Alternative& alternative : rule_of(rule).alternatives)
    result.push_back(with_alternative(choices, rule, alternative.name));
  return result;
}

Policy policy_of(const Choices& rules) {
  Policy policy;
  policy.rules = rules;
  return policy;
}

Policy policy_with(const Choices& rules, RuleId rule, const std::string& alternative) {
  Policy policy = policy_of(rules);
  policy.rules[name_of(rule)] = alternative;
  return policy;
}

Trait leading(TraitId id, std::span<const std::string> names, std::span<const std::size_t> agreeing,
              std::size_t of, std::size_t standard) {
  const auto most = std::max_element(agreeing.begin(), agreeing.end());
  const std::size_t first =
      agreeing[standard] == *most ? standard : static_cast<std::size_t>(most - agreeing.begin());
  std::size_t second = first == 0 ? 1 : 0;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (i != first && agreeing[i] > agreeing[second]) second = i;
  return {std::move(id), names[first],           {agreeing[first], of},
          names[second], {agreeing[second], of}, ""};
}

Tally::Tally(RuleId rule) : Tally(names_of_alternatives(rule)) {
  const auto standard = std::ranges::find(names_, rule_of(rule).standard);
  standard_ = static_cast<std::size_t>(standard - names_.begin());
}

void Tally::add(const std::vector<bool>& yields) {
  const auto count = std::count(yields.begin(), yields.end(), true);
  ++all_;
  if (count == 0) ++none_;
  if (count == 0 || count == static_cast<std::ptrdiff_t>(yields.size())) return;
  ++of_;
  for (std::size_t i = 0; i < yields.size(); ++i)
    if (yields[i]) ++agreeing_[i];
}

void Tally::add_all(const std::vector<Facts>& facts) {
  for (std::size_t i = 0; i < facts.front().size(); ++i) {
    std::vector<bool> yields;
    for (const Facts& alternative : facts) yields.push_back(alternative[i]);
    add(yields);
  }
}

Trait Tally::trait(TraitId id, None none) const {
  const std::size_t of = of_ + (none == None::counted ? none_ : 0);
  Trait trait = leading(std::move(id), names_, agreeing_, of, standard_);
  if (none_ > 0) trait.remark = fmt::format("nothing catalogued yields {} of {}", none_, all_);
  if (of > 0) return trait;
  if (none_ == 0) trait.remark = "no reported value distinguishes the alternatives";
  trait.runner_up.clear();
  trait.runner_up_rate = {};
  return trait;
}

Trait Tally::fitting(TraitId id) const {
  Trait found = trait(std::move(id), None::counted);
  const auto [agreeing, of] = found.rate;
  if (agreeing == of) return found;
  found.runner_up = found.alternative;
  found.runner_up_rate = found.rate;
  found.alternative = kNoneFits;
  found.rate = {of - agreeing, of};
  return found;
}

}  // namespace edgecase
