// SPDX-License-Identifier: MIT
#include "run/case_slices.h"

#include <algorithm>

namespace edgecase {
std::vector<CaseSlice> cut_cases(const CaseStore& cases, SliceLimits most) {
  std::vector<CaseSlice> slices;
  std::size_t weight = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::size_t more = cases.weight(i);
    const bool is_full =
        weight + more > most.weight || (!slices.empty() && i - slices.back().begin == most.cases);
    if (slices.empty() || is_full) {
      slices.push_back({i, i});
      weight = 0;
    }
    weight += more;
    slices.back().end = i + 1;
  }
  return slices;
}

}  // namespace edgecase
