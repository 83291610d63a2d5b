// SPDX-License-Identifier: MIT
#include "run/selection.h"

#include <fnmatch.h>

#include <algorithm>
#include <utility>

#include "casefile/loader.h"
#include "casefile/suite.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

bool matches_any(const std::vector<std::string>& globs, const std::string& id) {
  return std::any_of(globs.begin(), globs.end(), [&](const std::string& glob) {
    return fnmatch(glob.c_str(), id.c_str(), 0) == 0;
  });
}

bool wanted_id(const Selection& selection, const std::string& id) {
  if (!selection.filters.empty() && !matches_any(selection.filters, id)) return false;
  return !matches_any(selection.excludes, id);
}

bool wanted_tags(const Selection& selection, const Case& one) {
  return selection.tags.empty() ||
         std::any_of(one.tags.begin(), one.tags.end(), [&](const std::string& tag) {
           return std::find(selection.tags.begin(), selection.tags.end(), tag) !=
                  selection.tags.end();
         });
}

std::vector<std::string> known_rule_ids() {
  std::vector<std::string> ids;
  for (const Rule& rule : all_rules()) ids.push_back(rule.id);
  return ids;
}

// Round robin, so that shards are of one size and each sees every folder.
void keep_shard(const Shard& shard, std::vector<Case>& cases) {
  std::vector<Case> kept;
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (static_cast<int>(i % static_cast<std::size_t>(shard.count)) == shard.index)
      kept.push_back(std::move(cases[i]));
  cases = std::move(kept);
}

}  // namespace

Suite load_suite(const Selection& selection) {
  const std::vector<std::string> rules = known_rule_ids();
  FoundCases found = find_cases(selection.paths);
  Suite suite;
  suite.diagnostics = std::move(found.diagnostics);
  for (const CaseFile& file : found.cases) {
    if (!wanted_id(selection, file.id)) continue;
    LoadedCase loaded = load_case(file.file, file.id, rules);
    suite.diagnostics.insert(suite.diagnostics.end(), loaded.diagnostics.begin(),
                             loaded.diagnostics.end());
    if (loaded.value && wanted_tags(selection, *loaded.value))
      suite.cases.push_back(std::move(*loaded.value));
  }
  std::sort(suite.cases.begin(), suite.cases.end(),
            [](const Case& a, const Case& b) { return a.id < b.id; });
  keep_shard(selection.shard, suite.cases);
  return suite;
}

}  // namespace edgecase
