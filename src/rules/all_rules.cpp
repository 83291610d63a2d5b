// SPDX-License-Identifier: MIT
#include "rules/all_rules.h"

#include <algorithm>
#include <map>
#include <vector>

#include "rules/catalogue.h"

namespace edgecase {

std::map<int, RulingSource> ruling_sources() {
  std::map<int, RulingSource> all;
  add_coverage_sources(all);
  add_values_sources(all);
  add_samples_sources(all);
  add_textures_sources(all);
  add_output_sources(all);
  return all;
}

std::span<const Rule> all_rules() {
  static const std::vector<Rule> rules = [] {
    std::vector<Rule> complete = table_of_contents();
    const std::map<int, RulingSource> sources = ruling_sources();
    for (Rule& rule : complete) {
      for (Ruling& ruling : rule.rulings)
        if (const auto found = sources.find(ruling.number); found != sources.end())
          ruling.source = found->second;
      if (!rule.rulings.empty()) rule.ruling = rule.rulings.front().number;
    }
    return complete;
  }();
  return rules;
}

const Rule& rule_of(RuleId id) {
  static const std::vector<const Rule*> by_id = [] {
    std::vector<const Rule*> rules(values_of<RuleId>().size());
    for (const Rule& rule : all_rules()) rules[static_cast<std::size_t>(rule.id)] = &rule;
    return rules;
  }();
  return *by_id[static_cast<std::size_t>(id)];
}

const Rule* find_rule(std::string_view id) {
  RuleId known = RuleId::none;
  return !id.empty() && parse_name(id, known) ? &rule_of(known) : nullptr;
}

const Alternative* find_alternative(const Rule& rule, std::string_view name) {
  for (const Alternative& alternative : rule.alternatives)
    if (alternative.name == name) return &alternative;
  return nullptr;
}

AlternativeId alternative_id(RuleId rule, std::string_view name) {
  const std::vector<Alternative>& all = rule_of(rule).alternatives;
  const auto found = std::ranges::find(all, name, &Alternative::name);
  return {rule, static_cast<std::uint8_t>(found - all.begin())};
}

const Alternative* alternative_of(AlternativeId id) {
  const std::vector<Alternative>& all = rule_of(id.rule).alternatives;
  return id.index < all.size() ? &all[id.index] : nullptr;
}

std::string text_of(AlternativeId id) {
  std::string text = name_of(id.rule);
  if (const Alternative* alternative = alternative_of(id)) text += "=" + alternative->name;
  return text;
}

namespace {

constexpr std::string_view kBetween = " + ";

std::optional<AlternativeId> parse_alternative(std::string_view text) {
  const std::size_t equals = text.find('=');
  const Rule* rule = find_rule(text.substr(0, equals));
  if (rule == nullptr) return std::nullopt;
  if (equals == text.npos) return AlternativeId{rule->id};
  if (find_alternative(*rule, text.substr(equals + 1)) == nullptr) return std::nullopt;
  return alternative_id(rule->id, text.substr(equals + 1));
}

}  // namespace

std::string text_of(const Cause& cause) {
  std::string text;
  for (const AlternativeId part : cause.parts) {
    if (!text.empty()) text += kBetween;
    text += text_of(part);
  }
  return text;
}

std::optional<Cause> parse_cause(std::string_view text) {
  Cause cause;
  while (!text.empty()) {
    const std::size_t end = text.find(kBetween);
    const std::optional<AlternativeId> part = parse_alternative(text.substr(0, end));
    if (!part) return std::nullopt;
    cause.parts.push_back(*part);
    text = end == text.npos ? "" : text.substr(end + kBetween.size());
  }
  return cause;
}

bool is_open_choice(const Cause& cause) {
  return !cause.empty() && std::ranges::all_of(cause.parts, [](AlternativeId part) {
    const Alternative* alternative = alternative_of(part);
    return alternative != nullptr && alternative->openness != Openness::illegal;
  });
}

std::vector<KnownRule> known_rules() {
  std::vector<KnownRule> known;
  for (const Rule& rule : all_rules()) {
    known.push_back({name_of(rule.id), {}, rule.title});
    for (const Alternative& alternative : rule.alternatives)
      known.back().alternatives.push_back(alternative.name);
  }
  return known;
}

const Ruling* find_ruling(int number) {
  static const std::map<int, const Ruling*> rulings = [] {
    std::map<int, const Ruling*> numbered;
    for (const Rule& rule : all_rules())
      for (const Ruling& ruling : rule.rulings) numbered.emplace(ruling.number, &ruling);
    return numbered;
  }();
  const auto found = rulings.find(number);
  return found == rulings.end() ? nullptr : found->second;
}

std::vector<RulingFact> facts_of(const Ruling& ruling) {
  const RulingSource& source = ruling.source;
  std::vector<RulingFact> facts;
  const auto add = [&facts](const char* name, const std::string& text) {
    if (!text.empty()) facts.push_back({name, text});
  };
  add("Withdrawn", source.withdrawn);
  add("Basis",
      std::string(name_of(source.basis)) + (source.contest.empty() ? "" : ": " + source.contest));
  if (!source.clause.empty())
    add("Text", source.revision + ", " + source.clause + ": \"" + source.quotation + "\"");
  add("Conformance tests", source.khronos);
  add("OpenGL ES", source.es);
  return facts;
}

Legality legality_against(int ruling) {
  const Ruling* broken = find_ruling(ruling);
  return broken != nullptr && broken->source.basis == Basis::contested ? Legality::contested
                                                                       : Legality::illegal;
}

}  // namespace edgecase
