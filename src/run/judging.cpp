// SPDX-License-Identifier: MIT
#include "run/judging.h"

#include <algorithm>
#include <map>
#include <string>

#include "diff/coverage/legality.h"
#include "model/threads.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

constexpr const char* kReading = "lines read with snap, ";

}  // namespace

RunReadings read_all(const CaseList& cases) {
  std::map<ReadingKey, RunReader> readers;
  make_in_order(
      cases.size(), [&](std::size_t i) { return cases.whole(i); },
      [&](std::size_t, const CaseResults& one) {
        for (std::size_t r = 0; r < one.results.size(); ++r)
          readers[{r, one.surface}].add(one.results[r]);
      });
  RunReadings readings;
  for (const auto& [key, reader] : readers) readings.emplace(key, reader.reading());
  return readings;
}

void judge_all(Results& results) {
  const RunReadings readings = read_all(results.cases);
  for (RendererInfo& info : results.renderers)
    std::erase_if(info.traits, [](const auto& trait) { return is_of_judging(trait.first); });
  for (const auto& [key, reading] : readings)
    results.renderers[key.first].traits[kReading + key.second] = reading.line_snap;
  for_each_index(results.cases.size(), [&](std::size_t i) {
    CaseResults one = results.cases[i];
    bool differs = false;
    for (std::size_t r = 0; r < one.results.size(); ++r) {
      Result* const only = &one.results[r];
      differs = differs || !only->disagreements.empty() || !only->values.empty();
      judge({&only, 1}, results.latitude, readings.at({r, one.surface}));
      results.cases.answer(i, r) = *only;
    }
    // If everything agrees, judging changes only the outline.
    if (differs) results.cases.replace(i, one);
  });
}

bool is_of_judging(const std::string& trait) {
  return trait.starts_with(kReading);
}

bool is_surely_unexpected(const Case& one, const Result& result, Latitude latitude,
                          std::span<const KnownFault* const> faults) {
  const std::string surface = name_of(one.scene.target.surface);
  const auto is_known = [&](const auto&... what) {
    return std::ranges::any_of(faults, [&](const KnownFault* fault) {
      return accounts_for(*fault, one.id, surface, what...);
    });
  };
  if (result.failure)
    return result.failure->kind != FailureKind::unsupported && !is_known(*result.failure);
  if (latitude == Latitude::none) return !result.disagreements.empty() || !result.values.empty();
  return std::ranges::any_of(result.disagreements, [&](const Disagreement& d) {
    return !is_legal(d) && !is_about_a_line(d) && legality_against(d.ruling) == Legality::illegal &&
           !is_known(result, d);
  });
}

}  // namespace edgecase
