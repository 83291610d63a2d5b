// SPDX-License-Identifier: MIT
#include "suite/example_case.h"

#include <algorithm>
#include <array>
#include <set>
#include <tuple>
#include <utility>

#include "casefile/json/json_document.h"
#include "casefile/json/text.h"
#include "casefile/loader.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

std::string first_part(const std::string& id) {
  return id.substr(0, id.find('.'));
}

std::string last_part(const std::string& id) {
  return id.substr(id.rfind('.') + 1);
}

// Rules about the same primitive, or about the same choice for another one.
std::set<std::string> rules_near(const std::string& rule) {
  std::set<std::string> near;
  for (const std::string& other : names_of<RuleId>())
    if (other != rule &&
        (first_part(other) == first_part(rule) || last_part(other) == last_part(rule)))
      near.insert(other);
  return near;
}

auto size_of(const Case& one) {
  std::size_t vertices = 0;
  for (const Draw& draw : one.scene.draws) vertices += draw.vertices.size();
  return std::tuple(vertices, one.scene.target.width * one.scene.target.height, one.id);
}

// True if the text names one of the rules. Most files of a suite do not, and are not parsed.
bool mentions(const std::string& text, const std::set<std::string>& rules) {
  return std::ranges::any_of(rules, [&](const std::string& rule) {
    return text.find('"' + rule + '"') != std::string::npos;
  });
}

std::optional<ExampleCase> simplest_of(const std::vector<CaseFile>& files,
                                       const std::set<std::string>& rules) {
  std::optional<ExampleCase> best;
  for (const CaseFile& file : files) {
    const TextFile read = read_text_file(file.file, kMaxFileBytes);
    if (!read.text || !mentions(*read.text, rules)) continue;
    LoadedCases loaded = load_cases_text(*read.text, file.file, file.id);
    if (loaded.cases.empty()) continue;
    Case& base = loaded.cases.front();
    const auto named = std::ranges::find_if(
        base.rules, [&](const std::string& rule) { return rules.contains(rule); });
    if (named == base.rules.end()) continue;
    if (!best || size_of(base) < size_of(best->example))
      best = ExampleCase{*named, std::move(base)};
  }
  return best;
}

}  // namespace

std::optional<ExampleCase> simplest_case(const std::filesystem::path& suite,
                                         const std::string& rule) {
  const std::array paths = {suite};
  const FoundCases found = find_cases(paths);
  if (auto own = simplest_of(found.cases, {rule})) return own;
  return simplest_of(found.cases, rules_near(rule));
}

}  // namespace edgecase
