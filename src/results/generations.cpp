// SPDX-License-Identifier: MIT
#include "results/generations.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "results/comparison.h"
#include "results/standing.h"

namespace edgecase {
namespace {

void raise(CasesOn& cases, const std::string& release, std::size_t count) {
  std::size_t& most = cases[release];
  most = std::max(most, count);
}

// By product, then from older to newer releases.
bool is_older(const Release& a, const Release& b) {
  if (a.product != b.product) return a.product < b.product;
  if (a.numbers != b.numbers) return is_before(a.numbers, b.numbers);
  return a.is_es < b.is_es;
}

void add_release(DriverGenerations& driver, const Release& release) {
  const auto place =
      std::lower_bound(driver.releases.begin(), driver.releases.end(), release, is_older);
  if (place == driver.releases.end() || *place != release) driver.releases.insert(place, release);
}

std::size_t cases_of(const CasesOn& cases, const Release& release) {
  const auto found = cases.find(text_of(release));
  return found == cases.end() ? 0 : found->second;
}

// "all", "until Mesa 22.3.6", "since Mesa 26.2.6", "Mesa 25.0.7 alone": where the first
// and the last release that showed a fault stand among those that were run.
std::string words_of_span(const std::vector<Release>& releases, const CasesOn& cases) {
  std::size_t first = releases.size();
  std::size_t last = 0;
  for (std::size_t i = 0; i < releases.size(); ++i) {
    if (cases_of(cases, releases[i]) == 0) continue;
    first = std::min(first, i);
    last = i;
  }
  if (first == releases.size()) return "none";
  const bool from_first = first == 0;
  const bool to_last = last + 1 == releases.size();
  if (from_first && to_last) return "all";
  if (from_first) return "until " + text_of(releases[last]);
  if (to_last) return "since " + text_of(releases[first]);
  if (first == last) return text_of(releases[first]) + " alone";
  return text_of(releases[first]) + " to " + text_of(releases[last]);
}

}  // namespace

std::vector<GenerationRow> rows_of(const DriverGenerations& driver) {
  std::vector<GenerationRow> rows;
  const auto add = [&](const std::string& name, const CasesOn& cases) -> GenerationRow& {
    GenerationRow& row =
        rows.emplace_back(GenerationRow{name, {}, words_of_span(driver.releases, cases), "", ""});
    for (const Release& release : driver.releases) row.cases.push_back(cases_of(cases, release));
    return row;
  };
  for (const auto& [id, cases] : driver.faults) {
    GenerationRow& row = add(id, cases);
    row.reason = driver.reasons.at(id);
    row.smallest = driver.smallest.at(id);
  }
  add("not known", driver.unexpected);
  return rows;
}

std::vector<std::string> changed_rules(const DriverGenerations& driver) {
  std::vector<std::string> changed;
  for (const auto& [rule, on] : driver.rules) {
    std::set<std::string> different;
    std::vector<std::string> words;
    for (const Release& release : driver.releases)
      if (const auto found = on.find(text_of(release)); found != on.end()) {
        different.insert(found->second);
        words.push_back(fmt::format("{} on {}", found->second, found->first));
      }
    if (different.size() > 1)
      changed.push_back(fmt::format("{}: {}", rule, fmt::join(words, ", ")));
  }
  return changed;
}

std::optional<std::string> add_generation(Generations& generations, const Results& results) {
  if (!is_whole(results))
    return "they are not of the whole suite; a fault that they do not show need not be gone";
  for (std::size_t r = 0; r < results.renderers.size(); ++r) {
    const RendererInfo& info = results.renderers[r];
    DriverGenerations& driver = generations[driver_of(info)];
    const Release release = release_of(info);
    const std::string name = text_of(release);
    add_release(driver, release);
    raise(driver.unexpected, name, count_unexpected(results, r));
    for (const auto& [rule, remaining] : remaining_in(results, info.name))
      driver.rules[rule][name] = remaining;
    for (const FaultSeen& seen : results.faults) {
      if (seen.renderer != info.name || seen.cases == 0) continue;
      raise(driver.faults[seen.id], name, seen.cases);
      const std::string smallest = shortest_case_with(results, info.name, seen.id);
      if (driver.releases.back() == release) {
        driver.reasons[seen.id] = seen.reason;
        driver.smallest[seen.id] = smallest;
      }
      driver.reasons.emplace(seen.id, seen.reason);
      driver.smallest.emplace(seen.id, smallest);
    }
  }
  return std::nullopt;
}

}  // namespace edgecase
