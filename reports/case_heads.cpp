// SPDX-License-Identifier: MIT
#include "reports/case_heads.h"

#include <fmt/format.h>

#include <map>
#include <tuple>
#include <utility>

namespace edgecase {

std::string_view stem_of(const std::string& id) {
  return std::string_view(id).substr(0, id.find(':'));
}

namespace {

// Only cases that share all have the same.
std::string key_of(const CaseResults& one) {
  std::string key;
  const auto add = [&](std::string_view text) { key.append(text).push_back('\0'); };
  add(stem_of(one.id));
  for (const std::string& text : {one.title, one.why, one.file, one.surface, one.spec, one.origin})
    add(text);
  add(fmt::format("{} {} {}", one.width, one.height, one.rules.size()));
  for (const std::string& rule : one.rules) add(rule);
  for (const std::string& tag : one.tags) add(tag);
  return key;
}

}  // namespace

CaseHeads heads_of(const Results& results) {
  CaseHeads heads;
  std::map<std::string, std::size_t> numbers;  // by what cases share
  const auto number_of = [&](CaseResults one) {
    const auto [found, is_new] = numbers.try_emplace(key_of(one), heads.list.size());
    if (is_new) heads.list.push_back(std::move(one));
    return found->second;
  };
  using Place = decltype(std::declval<ShelvedCase>().head_place());
  std::map<std::tuple<Place, std::string_view, std::string_view>, std::size_t> known;
  for (std::size_t i = 0; i < results.cases.size(); ++i) {
    const ShelvedCase& one = results.cases.shelved(i);
    const auto [found, is_new] =
        known.try_emplace({one.head_place(), stem_of(one.outline.id), one.outline.surface}, 0);
    if (is_new) found->second = number_of(one.head());
    heads.of_case.push_back(found->second);
  }
  return heads;
}

}  // namespace edgecase
