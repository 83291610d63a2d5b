// SPDX-License-Identifier: MIT
//
// Results for tests: one with every field filled, and short ones.
#pragma once

#include "results/results.h"

namespace edgecase {

// Two renderers, two cases; every field of every type has a value that is not its default.
Results full_results();

// One answer with a gross fault: one disagreement in full, others only counted.
Results gross_results();

// One renderer "fake" and one case per verdict, ids "a", "b", ...; fingerprints are made of the id.
Results results_with(const std::vector<Verdict>& verdicts);

}  // namespace edgecase
