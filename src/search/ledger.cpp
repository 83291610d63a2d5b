// SPDX-License-Identifier: MIT
#include "search/ledger.h"

#include <algorithm>
#include <array>
#include <span>
#include <tuple>
#include <utility>

#include "search/grid_search.h"
#include "search/scene_size.h"

namespace edgecase {
namespace {

constexpr std::size_t kMostRead = 4096;  // results per surface, after which the reading is final
constexpr std::size_t kReadablePrimitives = 2;
constexpr std::size_t kMostOthers = 16;  // further scenes kept for a find

void judge_one(Result& result, Latitude latitude, const RunReading* reading) {
  const std::array<Result* const, 1> one{&result};
  if (reading == nullptr)
    judge(one, latitude);
  else
    judge(one, latitude, *reading);
}

// The parts that read_run uses.
Result stripped(const Result& result) {
  Result kept;
  kept.failure = result.failure;
  kept.evidence = result.evidence;
  kept.illegal_line_snaps = result.illegal_line_snaps;
  kept.refuted = result.refuted;
  return kept;
}

bool is_readable(const Scene& scene) {
  return fraction_bits_of(scene) <= kReadableBits;
}

// How far a scene exceeds what people read easily: primitives, then fraction bits.
std::pair<std::size_t, int> beyond_readable(const Scene& scene, int least_bits) {
  const std::size_t primitives = primitives_of(scene).size();
  return {std::max(primitives, kReadablePrimitives) - kReadablePrimitives,
          std::max(fraction_bits_of(scene) - std::max(kReadableBits, least_bits), 0)};
}
bool is_easier(const Find& a, const Find& b) {
  return beyond_readable(a.scene, 0) < beyond_readable(b.scene, 0);
}

// Whether `a` is a better start than `b`. Readable coordinates do not become finer again.
bool is_smaller(const Scene& a, const Scene& b) {
  const auto size = [](const Scene& scene) {
    return std::tuple(!is_readable(scene), primitives_of(scene).size(),
                      std::int64_t{scene.target.width} * scene.target.height);
  };
  return size(a) < size(b);
}

}  // namespace

void Ledger::know(Scene scene, Result result) {
  judge_one(result, latitude_, nullptr);
  for (Shown& shown : shown_by(scene, result, latitude_)) know(std::move(shown.key));
  known_.push_back({{std::move(scene), {}}, std::move(result)});
}

void Ledger::add(SourcedScene sourced, Result result) {
  Run& run = runs_[sourced.scene.target.surface];
  if (run.results.size() < kMostRead) run.results.push_back(stripped(result));
  pending_.push_back({std::move(sourced), std::move(result)});
}

void Ledger::read(bool all) {
  bool changed = false;
  for (auto& [surface, run] : runs_) {
    if (run.read == run.results.size() || (!all && run.results.size() < 2 * run.read)) continue;
    std::vector<Result*> results;
    for (Result& result : run.results) results.push_back(&result);
    readings_[surface] = read_run(results);
    run.read = run.results.size();
    changed = true;
  }
  if (!changed) return;
  keys_of_known_.clear();
  for (Pending& known : known_) {
    judge_under_reading(known.sourced.scene, known.result);
    for (Shown& shown : shown_by(known.sourced.scene, known.result, latitude_))
      keys_of_known_.insert(std::move(shown.key));
  }
  merge_finds();
}

void Ledger::judge_under_reading(const Scene& scene, Result& result) const {
  const auto reading = readings_.find(scene.target.surface);
  judge_one(result, latitude_, reading == readings_.end() ? nullptr : &reading->second);
}

bool Ledger::is_known(const FindKey& key) {
  if (!known_keys_.contains(key) && !keys_of_known_.contains(key)) return false;
  known_met_.insert(key);
  return true;
}

std::vector<Shown> Ledger::shown(const Pending& pending) const {
  std::vector<Shown> shown = shown_by(pending.sourced.scene, pending.result, latitude_);
  std::erase_if(shown, [&](const Shown& s) { return s.verdict < least_; });
  return shown;
}

std::vector<Candidate> Ledger::take_candidates() {
  read(false);
  std::vector<Candidate> candidates;
  std::map<FindKey, std::size_t> places;
  for (Pending& pending : pending_) {
    judge_under_reading(pending.sourced.scene, pending.result);
    const bool readable = is_readable(pending.sourced.scene);
    for (const Shown& what : shown(pending)) {
      const bool is_new = seen_[what.key]++ == 0;
      const auto place = places.find(what.key);
      const auto candidate = [&] {
        return Candidate{what.key, what.verdict, pending.sourced, pending.result};
      };
      const auto keep_other = [&](const SourcedScene& sourced, Verdict verdict) {
        if (lacks_others(what.key))
          others_[what.key].push_back({what.key, verdict, sourced, std::nullopt});
      };
      if (place == places.end()) {
        const bool is_better = readable && !readable_.contains(what.key);
        if (is_known(what.key)) continue;
        if (is_new || is_better) {
          places[what.key] = candidates.size();
          candidates.push_back(candidate());
        } else {
          keep_other(pending.sourced, what.verdict);
        }
        continue;
      }
      Candidate& taken = candidates[place->second];
      const bool is_better = is_smaller(pending.sourced.scene, taken.sourced.scene);
      if (is_better) {
        keep_other(taken.sourced, taken.verdict);
        taken = candidate();
      } else {
        keep_other(pending.sourced, what.verdict);
      }
    }
  }
  pending_.clear();
  for (const Candidate& candidate : candidates)
    if (is_readable(candidate.sourced.scene)) readable_.insert(candidate.key);
  return candidates;
}

bool Ledger::lacks_others(const FindKey& key) const {
  const auto others = others_.find(key);
  return others == others_.end() || others->second.size() < kMostOthers;
}

std::vector<Candidate> Ledger::take_others() {
  std::vector<Candidate> candidates;
  for (const Find& find : finds_) {
    if (beyond_readable(find.scene, find.least_bits) == beyond_readable({}, 0)) continue;
    const auto others = others_.find(find.key);
    if (others == others_.end() || others->second.empty()) continue;
    candidates.push_back(std::move(others->second.front()));
    others->second.pop_front();
  }
  return candidates;
}

bool Ledger::add_find(Find find) {
  judge_again(find);
  if (find.verdict < least_ || is_known(find.key)) return false;
  if (is_readable(find.scene)) readable_.insert(find.key);
  const auto same = std::ranges::find(finds_, find.key, &Find::key);
  if (same != finds_.end()) {
    if (is_easier(find, *same)) *same = std::move(find);
    return false;
  }
  // A minimized scene's finds need not be found again.
  ++seen_[find.key];
  finds_.push_back(std::move(find));
  return true;
}

// Under another reading a find may have another cause, which then defines it.
void Ledger::judge_again(Find& find) const {
  judge_under_reading(find.scene, find.result);
  const std::vector<Shown> shown = shown_by(find.scene, find.result, latitude_);
  const auto same = std::ranges::find_if(
      shown, [&](const Shown& s) { return s.key.signature == find.key.signature; });
  if (same != shown.end()) {
    find.key = same->key;
    find.verdict = same->verdict;
  } else if (!shown.empty()) {
    find.key = shown.front().key;
    find.verdict = shown.front().verdict;
  }
}

void Ledger::merge_finds() {
  std::vector<Find> kept;
  for (Find& find : finds_) {
    judge_again(find);
    if (is_known(find.key)) continue;
    const auto same = std::ranges::find(kept, find.key, &Find::key);
    if (same == kept.end())
      kept.push_back(std::move(find));
    else if (is_easier(find, *same))
      *same = std::move(find);
  }
  finds_ = std::move(kept);
}

std::vector<Find> Ledger::take_finds() {
  read(true);
  for (Find& find : finds_) {
    const auto seen = seen_.find(find.key);
    find.scenes = seen == seen_.end() ? 1 : seen->second;
  }
  std::ranges::stable_sort(finds_, [](const Find& a, const Find& b) {
    return std::tuple(-static_cast<int>(a.verdict), a.key) <
           std::tuple(-static_cast<int>(b.verdict), b.key);
  });
  return std::move(finds_);
}

}  // namespace edgecase
