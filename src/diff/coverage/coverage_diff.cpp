// SPDX-License-Identifier: MIT
#include "diff/coverage/coverage_diff.h"

#include <algorithm>

namespace edgecase {
namespace {

void add(const Fragment& fragment, SampleCoverage& coverage) {
  for (std::size_t s = 0; s < coverage.size(); ++s)
    if ((fragment.coverage >> s & 1) != 0) coverage[s].push_back({fragment.x, fragment.y});
}

// Adds one side of a rendering to the coverage of its primitives.
void add_side(const Rendering& rendering, SampleCoverage PrimitiveCoverage::*side,
              std::vector<PrimitiveCoverage>& result) {
  std::vector<std::size_t> counts(result.size());
  for (const Fragment& f : rendering.fragments) ++counts.at(static_cast<std::size_t>(f.primitive));
  for (std::size_t i = 0; i < result.size(); ++i)
    for (auto& pixels : result[i].*side) pixels.reserve(counts[i]);
  for (const Fragment& f : rendering.fragments)
    add(f, result[static_cast<std::size_t>(f.primitive)].*side);
}

}  // namespace

std::vector<PrimitiveCoverage> match_coverage(std::size_t primitives, const Rendering& exact,
                                              const Rendering& drawn) {
  const SampleCoverage none(static_cast<std::size_t>(exact.samples));
  std::vector<PrimitiveCoverage> result(primitives, {none, none});
  add_side(exact, &PrimitiveCoverage::exact, result);
  // Most renderers cover what exact covers, and copying is cheaper than matching fragments.
  if (std::ranges::equal(exact.fragments, drawn.fragments, cover_alike)) {
    for (PrimitiveCoverage& coverage : result) coverage.drawn = coverage.exact;
    return result;
  }
  add_side(drawn, &PrimitiveCoverage::drawn, result);
  return result;
}

std::vector<CoverageDifference> differences(const PrimitiveCoverage& coverage) {
  std::vector<CoverageDifference> result;
  for_each_difference(coverage,
                      [&](const CoverageDifference& difference) { result.push_back(difference); });
  return result;
}

}  // namespace edgecase
