// SPDX-License-Identifier: MIT
//
// Cuts a suite's cases into slices that cost about the same: what one thread takes at a time.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "run/case_store.h"

namespace edgecase {

// The cases of a slice: [begin, end).
struct CaseSlice {
  std::size_t begin = 0;
  std::size_t end = 0;
};

struct SliceLimits {
  std::size_t weight = 0;                                       // CaseStore::weight, in all
  std::size_t cases = std::numeric_limits<std::size_t>::max();  // at least 1
};

// Slices in the order of the cases, each within the limits or of one case that weighs more. No
// case, no slice.
std::vector<CaseSlice> cut_cases(const CaseStore& cases, SliceLimits most);

}  // namespace edgecase
