// SPDX-License-Identifier: MIT
//
// What a ramp (Result::ramp) says: how far the levels of detail that a renderer tells are from the
// exact ones, and from the band that is permitted.
//
// All numbers are compared as float32, as src/diff does: that is what a renderer has. Distances are
// in levels; equal infinities are no distance apart.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "model/result.h"

namespace edgecase {

struct RampSummary {
  std::size_t fragments = 0;
  std::size_t unknown = 0;           // exact is NaN; in no distance
  std::size_t not_numbers = 0;       // rendered alone is NaN; outside the band, in no distance
  std::size_t infinitely_far = 0;    // from exact; in no distance
  double from_exact = 0;             // the largest finite distance
  double from_band = 0;              // the same, 0 where all is inside
  std::vector<std::size_t> outside;  // indices of the points outside the band, rising
  // Index of the point farthest from exact, the first of several; none where all equal exact. What
  // is not a number is farther than what is infinitely far.
  std::optional<std::size_t> farthest;
};

RampSummary summarize_ramp(const std::vector<Result::LevelPoint>& ramp);

// A sentence: "At most 0.0859 of a level from exact, inside the permitted band."
std::string words_of(const RampSummary& summary);

// The alternatives that the specification leaves open and that the result's levels of detail
// follow, as causes, each once; none where some level follows no such alternative.
std::vector<std::string> open_causes_of_levels(const Result& result);

}  // namespace edgecase
