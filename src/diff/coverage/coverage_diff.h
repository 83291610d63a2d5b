// SPDX-License-Identifier: MIT
//
// Match: whose fragments of a primitive are missing, extra or doubled. Sets only; no rule.
#pragma once

#include <vector>

#include "exact/pixel.h"
#include "model/rendering.h"
#include "model/sampling.h"

namespace edgecase {

// The samples that the fragments of one primitive cover in two renderings, by sample index.
struct PrimitiveCoverage {
  SampleCoverage exact;  // each pixel once
  SampleCoverage drawn;  // each pixel as often as it came
};

// One entry per primitive of the scene.
std::vector<PrimitiveCoverage> match_coverage(std::size_t primitives, const Rendering& exact,
                                              const Rendering& drawn);

// A sample on which the two sides differ, with the number of hits on each.
struct CoverageDifference {
  PixelPosition pixel;
  int sample = 0;
  int exact = 0;
  int drawn = 0;
};

// Sorted by sample, row, column.
std::vector<CoverageDifference> differences(const PrimitiveCoverage& coverage);

}  // namespace edgecase
