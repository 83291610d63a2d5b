// SPDX-License-Identifier: MIT
//
// Where most intervals meet.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "exact/interval.h"

namespace edgecase {

struct Weighed {
  Interval interval;
  std::size_t weight = 1;
};

// The interval where the intervals of most weight meet; of several, the lowest. Nothing if there
// are none.
std::optional<Interval> where_most_meet(const std::vector<Weighed>& all);

}  // namespace edgecase
