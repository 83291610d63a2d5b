// SPDX-License-Identifier: MIT
//
// Judging a run's results: one judgement for each renderer and surface, since what is read in one
// way is what is drawn in one way. A run is judged so when it ends, and again when its shards are
// merged: a shard alone may read its lines otherwise than the whole.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "diff/judge.h"
#include "results/results.h"

namespace edgecase {

using ReadingKey = std::pair<std::size_t, std::string>;  // index of the renderer, surface
using RunReadings = std::map<ReadingKey, RunReading>;

// How each renderer's answers on each surface are read.
RunReadings read_all(const CaseList& cases);

// Fills what judge() fills of all results, by results.latitude, and the renderers' traits that say
// how lines are read.
void judge_all(Results& results);

// Is it a trait that judging makes, rather than the renderer?
bool is_of_judging(const std::string& trait);

}  // namespace edgecase
