// SPDX-License-Identifier: MIT
//
// Rules and causes as tests write them: "line.joint", "line.snap=none + line.algorithm=dda".
#pragma once

#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "model/verdict.h"
#include "rules/all_rules.h"
#include "rules/choices.h"

namespace edgecase {

inline RuleId rule_named(std::string_view id) {
  const Rule* rule = find_rule(id);
  if (rule == nullptr) throw std::invalid_argument("no rule " + std::string(id));
  return rule->id;
}

inline Cause cause_named(std::string_view text) {
  const std::optional<Cause> cause = parse_cause(text);
  if (!cause) throw std::invalid_argument("no cause " + std::string(text));
  return *cause;
}

inline std::vector<Cause> causes_named(const std::vector<std::string>& texts) {
  std::vector<Cause> causes;
  for (const std::string& text : texts) causes.push_back(cause_named(text));
  return causes;
}

inline bool operator==(RuleId rule, std::string_view id) {
  return name_of(rule) == id;
}
inline bool operator==(const Cause& cause, std::string_view text) {
  return text_of(cause) == text;
}

inline std::vector<std::string> texts_of(const std::vector<Cause>& causes) {
  std::vector<std::string> texts;
  for (const Cause& cause : causes) texts.push_back(text_of(cause));
  return texts;
}

// "rule=alternative" of each part.
inline std::vector<std::string> parts_of(std::string_view cause) {
  std::vector<std::string> parts;
  for (const AlternativeId part : cause_named(cause).parts) parts.push_back(text_of(part));
  return parts;
}

inline bool is_open_choice(std::string_view cause) {
  return is_open_choice(cause_named(cause));
}

// Of every alternative that a primitive which agrees can refute.
inline std::vector<std::string> alternative_names() {
  std::vector<std::string> names;
  for (const RuleId rule : coverage_rules())
    for (const Alternative& alternative : rule_of(rule).alternatives)
      names.push_back(text_of(alternative_id(rule, alternative.name)));
  names.push_back(name_of(RuleId::window_origin));
  return names;
}

// What a test that fails shows.
inline std::ostream& operator<<(std::ostream& out, RuleId rule) {
  return out << name_of(rule);
}
inline std::ostream& operator<<(std::ostream& out, const Cause& cause) {
  return out << text_of(cause);
}

}  // namespace edgecase
