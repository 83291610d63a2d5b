// SPDX-License-Identifier: MIT
#include "diff/coverage_diff.h"

#include <map>
#include <utility>

namespace edgecase {

std::vector<PrimitiveCoverage> match_coverage(std::size_t primitives, const Rendering& exact,
                                              const Rendering& drawn) {
  std::vector<PrimitiveCoverage> result(primitives);
  for (const Fragment& f : exact.fragments)
    result.at(static_cast<std::size_t>(f.primitive)).exact.push_back({f.x, f.y});
  for (const Fragment& f : drawn.fragments)
    result.at(static_cast<std::size_t>(f.primitive)).drawn.push_back({f.x, f.y});
  return result;
}

std::vector<CoverageDifference> differences(const PrimitiveCoverage& coverage) {
  // Keyed by row, then column: the order of the result.
  std::map<std::pair<int, int>, CoverageDifference> hits;
  for (PixelPosition p : coverage.exact) {
    CoverageDifference& entry = hits[{p.y, p.x}];
    entry.pixel = p;
    ++entry.exact;
  }
  for (PixelPosition p : coverage.drawn) {
    CoverageDifference& entry = hits[{p.y, p.x}];
    entry.pixel = p;
    ++entry.drawn;
  }
  std::vector<CoverageDifference> result;
  for (const auto& [key, entry] : hits)
    if (entry.exact != entry.drawn) result.push_back(entry);
  return result;
}

}  // namespace edgecase
