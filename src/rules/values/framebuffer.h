// SPDX-License-Identifier: MIT
//
// The value that a pixel ends up with (GL 4.6 core, 2.3.5.2, 2.1 and 17.3).
//
// Without blending and depth test the last fragment drawn wins. Its colour is converted to the
// target's format. Each component is clamped to [0, 1], scaled by 255, and rounded to one of the
// two nearest integers. The nearest is preferred. A pixel without a fragment keeps the clear
// colour.
#pragma once

#include <cstdint>

#include "exact/interval.h"
#include "rules/rule.h"

namespace edgecase {

Rule unorm8_rule();
Rule order_rule();

struct Unorm8Range {
  int low = 0;   // inclusive
  int high = 0;  // inclusive
};

// Values that the conversion of any number in `value` may yield: either neighbour of an
// intermediate value.
Unorm8Range unorm8_permitted(Interval value);

}  // namespace edgecase
