// SPDX-License-Identifier: MIT
//
// The colour that a pixel, a sample or a fragment should have: exact's, and the bounds of what a
// renderer may have instead.
#pragma once

#include <array>
#include <vector>

#include "exact/interval.h"
#include "model/rule_id.h"

namespace edgecase {

// Component by component, before conversion to 8 bits.
struct PixelTruth {
  // Wider bounds, beyond `permitted`, that a contested ruling accepts.
  struct Contested {
    RuleId rule{};
    int ruling = 0;
    std::array<Interval, 4> bounds{};
  };

  std::array<double, 4> exact{};
  std::array<Interval, 4> permitted{};
  std::vector<Contested> contested{};  // the narrowest first
};

}  // namespace edgecase
