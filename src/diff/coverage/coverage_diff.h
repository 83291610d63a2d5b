// SPDX-License-Identifier: MIT
//
// Which fragments of a primitive are missing, extra or doubled.
#pragma once

#include <cstddef>
#include <span>
#include <tuple>
#include <vector>

#include "exact/fixed.h"
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

}  // namespace edgecase
