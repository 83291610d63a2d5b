// SPDX-License-Identifier: MIT
#include "run/judging.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "base/threads.h"
#include "diff/coverage/legality.h"
#include "results/standing.h"

namespace edgecase {
namespace {

constexpr const char* kReading = "lines read with snap, ";

// Judges the cases of whose outlines `is_wanted` is true, and sets the traits.
template <class Wanted>
void judge_those(Results& results, RunReadings readings, const Wanted& is_wanted) {
  for (RendererInfo& info : results.renderers)
    std::erase_if(info.traits, [](const auto& trait) { return is_of_judging(trait.first); });
  for (const auto& [key, reading] : readings) {
    std::map<std::string, std::string>& traits = results.renderers[key.first].traits;
    traits[kReading + key.second] = reading.line_snap;
    for (const auto& [name, value] : traits_of(reading.things))
      traits[name + ", " + key.second] = value;
  }
  results.rules.clear();
  for (auto& [key, reading] : readings) {
    const RendererInfo& info = results.renderers[key.first];
    reading.subpixel_bits = info.subpixel_bits;
    results.refuted[info.name][key.second] = refuted_in(reading);
    if (!reading.rules.empty()) results.rules[info.name][key.second] = std::move(reading.rules);
  }
  for_each_index(results.cases.size(), [&](std::size_t i) {
    if (!is_wanted(results.cases.outline(i))) return;
    CaseResults one = results.cases[i];
    bool differs = false;
    for (std::size_t r = 0; r < one.results.size(); ++r) {
      Result* const only = &one.results[r];
      judge({&only, 1}, results.latitude, readings.at({r, one.surface}));
      differs = differs || !only->disagreements.empty() || !only->values.empty();
      results.cases.answer(i, r) = *only;
    }
    // If everything agrees, judging changes only the outline.
    if (differs) results.cases.replace(i, one);
  });
}

}  // namespace

void RunReaders::add(const CaseResults& one) {
  const std::lock_guard lock(mutex_);
  for (std::size_t r = 0; r < one.results.size(); ++r)
    readers_[{r, one.surface}].add(one.results[r], one.id);
}

RunReadings RunReaders::readings() const {
  const std::lock_guard lock(mutex_);
  RunReadings readings;
  for (const auto& [key, reader] : readers_) readings.emplace(key, reader.reading());
  return readings;
}

RunReadings read_all(const CaseList& cases) {
  RunReaders readers;
  for_each_index(cases.size(), [&](std::size_t i) { readers.add(cases.whole(i)); });
  return readers.readings();
}

void judge_all(Results& results) {
  judge_those(results, read_all(results.cases), [](const CaseOutline&) { return true; });
}

void judge_alone(CaseResults& one, Latitude latitude) {
  for (Result& result : one.results) {
    Result* const only = &result;
    if (!depends_on_run(result)) judge({&only, 1}, latitude, {});
  }
}

void judge_rest(Results& results, const RunReadings& readings) {
  const bool has_refuted_things = std::ranges::any_of(readings, [](const auto& reading) {
    return std::ranges::any_of(reading.second.things,
                               [](const auto& thing) { return thing.second.is_refuted; });
  });
  judge_those(results, readings, [&](const CaseOutline& one) {
    return one.depends_on_run || (has_refuted_things && one.shows_things);
  });
}

bool is_of_judging(const std::string& trait) {
  return trait.starts_with(kReading) || is_of_a_thing(trait);
}

bool is_surely_unexpected(const Case& one, Result result, Latitude latitude,
                          std::span<const KnownFault* const> faults) {
  if (latitude == Latitude::opengl) {
    std::erase_if(result.disagreements, is_about_a_line);
    std::erase_if(result.counted, is_about_a_line);
  }
  Result* const only = &result;
  judge({&only, 1}, latitude, {});
  CaseResults asked;
  asked.id = one.id;
  asked.surface = name_of(one.scene.target.surface);
  return standing_of(asked, std::move(result), faults, latitude) == Standing::unexpected;
}

void conclude(Results& results, const Conclusion& how) {
  const auto hold = [&] {
    apply_known_faults(results, how.known);
    if (how.strict) hold_contested(results);
  };
  hold();
  if (!how.ask_again) return;
  how.ask_again(results);
  hold();
}

}  // namespace edgecase
