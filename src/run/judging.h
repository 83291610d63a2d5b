// SPDX-License-Identifier: MIT
//
// Judging a run's results: one judgement for each renderer and surface, since what is read in one
// way is what is drawn in one way. A run is judged so when it ends, and again when its shards are
// merged: a shard alone may read its lines otherwise than the whole.
#pragma once

#include <string>

#include "results/results.h"

namespace edgecase {

// Fills what judge() fills of all results, by results.latitude, and the renderers' traits that say
// how lines are read.
void judge_all(Results& results);

// Is it a trait that judging makes, rather than the renderer?
bool is_of_judging(const std::string& trait);

}  // namespace edgecase
