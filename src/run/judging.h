// SPDX-License-Identifier: MIT
//
// Judges a run's results, separately for each renderer and surface, because a renderer draws lines
// in one way on a surface. A run is judged when it ends, and again when shards are merged: a shard
// alone may read its lines under another snap than the whole run.
#pragma once

#include <cstddef>
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

// Early judgement: a verdict on one answer before the run ends.
//
// Verdicts depend on the whole run (diff/judge.h): the reading of lines decides whether a line is
// legal. Two things do not depend on it: illegal differences of other primitives, and failures. A
// run that ends after a number of unexpected cases counts the cases that are unexpected for these
// reasons; others are found at its end.

// True if the answer, compared and not yet judged, is unexpected under every reading of the run.
// `faults`: the known faults of the renderer's release.
bool is_surely_unexpected(const Case& one, const Result& result, Latitude latitude,
                          std::span<const KnownFault* const> faults);

}  // namespace edgecase
