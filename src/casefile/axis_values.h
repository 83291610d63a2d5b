// SPDX-License-Identifier: MIT
//
// Reads the values of a sweep's axis in the three forms that a file may give them.
//
// Numbers are exact numerals of magnitude 16384 at most, or, in a list of values that are set,
// float32 numbers of magnitude 2^64 at most; what they may be where they go is checked by the
// reader of that place. The same holds for words, colours and points.
#pragma once

#include <vector>

#include "casefile/sweep.h"

namespace edgecase {

// [value, ...]: numbers, and unless they are added, words, true, false and colours, none twice.
std::vector<AxisValue> read_values(const Place& place, bool numbers_only, Findings& findings);

// {"from", "to", "step"}: from, from + step, and so on, as long as it is not above to.
std::vector<AxisValue> read_range(const Place& place, Findings& findings);

// [vertex, ...]: arrays or objects, none twice.
std::vector<AxisValue> read_points(const Place& place, Findings& findings);

}  // namespace edgecase
