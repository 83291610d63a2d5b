// SPDX-License-Identifier: MIT
//
// Cuts a suite's cases into slices that cost about the same: what one thread takes at a time.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "model/case.h"

namespace edgecase {

// The cases of a slice: [begin, end).
struct CaseSlice {
  std::size_t begin = 0;
  std::size_t end = 0;
};

struct SliceLimits {
  // As many as a case's target has samples, once a pass where it is supersampled, and 256 beside
  // them for each case.
  std::size_t weight = 0;
  std::size_t cases = std::numeric_limits<std::size_t>::max();  // at least 1
};

// Slices in the order of the cases, each within the limits or of one case that weighs more. No
// case, no slice.
std::vector<CaseSlice> cut_cases(const std::vector<Case>& cases, SliceLimits most);

}  // namespace edgecase
