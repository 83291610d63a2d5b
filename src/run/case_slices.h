// SPDX-License-Identifier: MIT
//
// Cuts a suite's cases into slices that cost about the same: what one thread takes at a time.
#pragma once

#include <cstddef>
#include <vector>

#include "model/case.h"

namespace edgecase {

// The cases of a slice: [begin, end).
struct CaseSlice {
  std::size_t begin = 0;
  std::size_t end = 0;
};

// Slices in the order of the cases, of `most_weight` each at most, or of one case that weighs more.
// A case weighs as many as its target has samples, once a pass where it is supersampled, and 256
// beside them. No case, no slice.
std::vector<CaseSlice> cut_cases(const std::vector<Case>& cases, std::size_t most_weight);

}  // namespace edgecase
