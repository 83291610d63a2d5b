// SPDX-License-Identifier: MIT
//
// Which fragments of a primitive are missing, extra or doubled, and the report of each: where it
// lies, and why it is covered or not.
#pragma once

#include <span>
#include <string>
#include <tuple>
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

// A sample of a primitive: its index, row and column.
using SamplePlace = std::tuple<int, int, int>;
inline SamplePlace sample_place(const CoverageDifference& difference) {
  return {difference.sample, difference.pixel.y, difference.pixel.x};
}

// Calls `visit` with each difference of one sample's pixels, both sorted by row and column.
template <class Visit>
void for_each_difference(std::span<const PixelPosition> exact, std::span<const PixelPosition> drawn,
                         int sample, const Visit& visit) {
  const auto reads_before = [](PixelPosition a, PixelPosition b) {
    return a.y != b.y ? a.y < b.y : a.x < b.x;
  };
  auto own = exact.begin();
  auto other = drawn.begin();
  while (own != exact.end() || other != drawn.end()) {
    const bool is_own = other == drawn.end() || (own != exact.end() && !reads_before(*other, *own));
    CoverageDifference at{is_own ? *own : *other, sample};
    for (; own != exact.end() && *own == at.pixel; ++own) ++at.exact;
    for (; other != drawn.end() && *other == at.pixel; ++other) ++at.drawn;
    if (at.exact != at.drawn) visit(at);
  }
}

// Sorted by sample, row, column.
std::vector<CoverageDifference> differences(const PrimitiveCoverage& coverage);

// The same one by one. The pixels of both sides must be sorted by row and column, as match_coverage
// has them.
template <class Visit>
void for_each_difference(const PrimitiveCoverage& coverage, const Visit& visit) {
  for (std::size_t s = 0; s < coverage.exact.size(); ++s)
    // The usual case; comparing is much cheaper than counting.
    if (coverage.exact[s] != coverage.drawn[s])
      for_each_difference(coverage.exact[s], coverage.drawn[s], static_cast<int>(s), visit);
}

// -------------------------------------------------------------------------------- what is reported

// A sample that a primitive should cover and does not, or covers and should not. Legality and cause
// are left open.
DisagreementClass class_of(const ScenePrimitive& primitive, const CoverageDifference& difference,
                           const Target& target);

// A sample that is covered more than once (ruling 7).
DisagreementClass class_of_duplicate(const ScenePrimitive& primitive,
                                     const CoverageDifference& difference);

// Fills in what both have in full, but for explanation and figure. `sample`: its position in the
// window.
void describe_sample(const ScenePrimitive& primitive, const CoverageDifference& difference,
                     Point sample, const Target& target, Disagreement& d);
// Explains a sample that only one side covers, by exact's choice. `sample`: its position in the
// window under that choice.
void explain_difference(const ScenePrimitive& primitive, const CoverageDifference& difference,
                        Point sample, const Target& target, const CoverageChoice& choice,
                        Disagreement& d);
// Explains a sample that is covered more than once.
void explain_duplicate(const CoverageDifference& difference, Point sample, const Target& target,
                       Disagreement& d);

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
