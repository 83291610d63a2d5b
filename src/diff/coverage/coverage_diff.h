// SPDX-License-Identifier: MIT
//
// Which fragments of a primitive are missing, extra or doubled, and the report of each: where it
// lies, and why it is covered or not.
#pragma once

#include <string>
#include <vector>

#include "exact/fixed.h"
#include "model/rendering.h"
#include "model/sampling.h"
#include "model/scene.h"
#include "model/verdict.h"
#include "rules/choices.h"
#include "rules/rule.h"

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

// -------------------------------------------------------------------------------- what is reported

// A sample that a primitive should cover and does not, or covers and should not. `sample`: its
// position in the window. Legality, cause and explanation are left open.
Disagreement at_sample(const ScenePrimitive& primitive, const CoverageDifference& difference,
                       Point sample, const Target& target);

// Reports a sample that is covered more than once; complete (ruling 7).
Disagreement duplicate(const ScenePrimitive& primitive, const CoverageDifference& difference,
                       Point sample, const Target& target);

// Merges names of snaps into `names`, in catalogue order.
void merge_snaps(const std::vector<std::string>& more, std::vector<std::string>& names);

// Why a primitive covers a sample under a choice of rules, or does not: a sentence with numbers by
// the rule that decides, and its figure. For a line that is not multisampled, the sample is the
// centre of the pixel.
Explanation explain(const ScenePrimitive& primitive, Point sample, const Target& target,
                    const CoverageChoice& choice);

// The position of a sample relative to a primitive, in text that many disagreements can share.
// Differences that no catalogued alternative explains are sorted by geometry: all first pixels of
// vertical lines that start on the lower corner of their diamond belong together, wherever the
// lines lie.
//
// Uses the vertices as given and, for a line that is not multisampled, the pixel:
// "line, vertical down, first pixel, start on the lower corner of its diamond",
// "triangle, sample exactly on a left edge", "point of size 1, centre exactly on the top side".
// Vertices that are quotients are rounded to a multiple of 2^-16, which the text says.
std::string situation_of(const ScenePrimitive& primitive, Point sample, const Target& target);

}  // namespace edgecase
