// SPDX-License-Identifier: MIT
//
// Judges a run's results, separately for each renderer and surface, because a renderer draws lines
// in one way on a surface. A run is judged when it ends, and again when shards are merged: a shard
// alone may read its lines under another snap than the whole run.
//
// These are the passes between comparing and reports (CONTRIBUTING.md, "The way of an answer").
// After each, this holds of all results:
//
//   read       it is known which alternatives a renderer's answers on a surface support and refute
//   judge      each primitive has its likeliest cause, each answer its verdict and fingerprint
//   hold       each answer has its standing, by the known faults and, if strict, by its verdict
//   ask again  what was unexpected and was answered otherwise a second time has both answers
//   hold       that is a flake
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <utility>

#include "diff/judge.h"
#include "model/case.h"
#include "model/policy.h"
#include "results/known_faults.h"
#include "results/results.h"

namespace edgecase {

using ReadingKey = std::pair<std::size_t, std::string>;  // index of the renderer, surface
using RunReadings = std::map<ReadingKey, RunReading>;

// The readings of cases that come one after the other, in any order. Safe to use from several
// threads.
class RunReaders {
 public:
  void add(const CaseResults& one);
  // The reading of each renderer's answers on each surface.
  RunReadings readings() const;

 private:
  mutable std::mutex mutex_;
  std::map<ReadingKey, RunReader> readers_;
};

// The same of a list.
RunReadings read_all(const CaseList& cases);

// Calls judge() for all results, with results.latitude, and sets the renderers' traits that say how
// lines are read.
void judge_all(Results& results);

// The same in two steps: each case when it is complete, and then, with the readings of all, those
// for which the run matters. Most are judged without being read again.

// Judges the results of a case for which the run does not matter (depends_on_run).
void judge_alone(CaseResults& one, Latitude latitude);
// Judges the cases with other results, and sets the traits.
void judge_rest(Results& results, const RunReadings& readings);

// True if judging sets the trait, and not the renderer.
bool is_of_judging(const std::string& trait);

// Early judgement: whether one answer, compared and not yet judged, is unexpected under every
// reading of the run. The reading decides whether a line is legal (diff/judge.h), so lines are left
// out; the rest is judged and held as at the run's end. A run that ends after a number of
// unexpected cases counts these; others are found at its end. `faults`: the known faults of the
// renderer's release.
bool is_surely_unexpected(const Case& one, Result result, Latitude latitude,
                          std::span<const KnownFault* const> faults);

struct Conclusion {
  std::span<const KnownFaults> known;
  bool strict = false;                           // what is contested is unexpected, too
  std::function<void(Results&)> ask_again = {};  // run/rerun.h; empty: nothing is asked again
};

// Holds judged results: of a run, of merged shards, or of a file with other known faults.
void conclude(Results& results, const Conclusion& how);

}  // namespace edgecase
