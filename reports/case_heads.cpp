// SPDX-License-Identifier: MIT
#include "reports/case_heads.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "model/threads.h"

namespace edgecase {

std::string_view stem_of(const std::string& id) {
  return std::string_view(id).substr(0, id.find(':'));
}

namespace {

struct Head {
  std::string key;  // that only cases which share all have
  CaseResults one;
};

Head head_of(CaseResults one) {
  Head head;
  const auto add = [&](std::string_view text) { head.key.append(text).push_back('\0'); };
  add(stem_of(one.id));
  for (const std::string& text : {one.title, one.why, one.file, one.surface, one.spec, one.origin})
    add(text);
  add(fmt::format("{} {} {}", one.width, one.height, one.rules.size()));
  for (const std::string& rule : one.rules) add(rule);
  for (const std::string& tag : one.tags) add(tag);
  one.pixels = {};
  one.samples = {};
  one.figure = {};
  one.results.clear();
  head.one = std::move(one);
  return head;
}

}  // namespace

CaseHeads heads_of(const Results& results) {
  CaseHeads heads;
  std::map<std::string, std::size_t> numbers;  // by what cases share
  const auto make = [&](std::size_t i) { return head_of(results.cases[i]); };
  make_in_order(results.cases.size(), make, [&](std::size_t, Head head) {
    const auto [found, is_new] = numbers.try_emplace(std::move(head.key), heads.list.size());
    if (is_new) heads.list.push_back(std::move(head.one));
    heads.of_case.push_back(found->second);
  });
  return heads;
}

}  // namespace edgecase
