// SPDX-License-Identifier: MIT
//
// Match: whose fragments of a primitive are missing, extra or doubled. Sets only; no rule.
#pragma once

#include <vector>

#include "exact/pixel.h"
#include "model/rendering.h"

namespace edgecase {

// The fragments of one primitive in two renderings.
struct PrimitiveCoverage {
  std::vector<PixelPosition> exact;  // row first, each once
  std::vector<PixelPosition> drawn;  // row first, each as often as it came
};

// One entry per primitive of the scene.
std::vector<PrimitiveCoverage> match_coverage(std::size_t primitives, const Rendering& exact,
                                              const Rendering& drawn);

// Pixels on which the two sides differ, with the number of hits on each.
struct CoverageDifference {
  PixelPosition pixel;
  int exact = 0;
  int drawn = 0;
};

std::vector<CoverageDifference> differences(const PrimitiveCoverage& coverage);

}  // namespace edgecase
