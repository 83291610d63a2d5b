// SPDX-License-Identifier: MIT
//
// A summary of a ramp (Result::ramp): the distances of a renderer's levels of detail from the exact
// ones and from the permitted band.
//
// All numbers are compared as float32, the precision of renderers, as in src/diff. Distances are in
// levels; that of equal infinities is 0.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "model/result.h"

namespace edgecase {

struct RampSummary {
  std::size_t fragments = 0;
  std::size_t unknown = 0;           // points where exact is NaN, which have no distance
  std::size_t not_numbers = 0;       // only the renderer's is NaN: outside the band, no distance
  std::size_t infinitely_far = 0;    // from exact; without a distance
  double from_exact = 0;             // the largest finite distance
  double from_band = 0;              // the same, 0 if all points are inside
  std::vector<std::size_t> outside;  // ascending indices of the points outside the band
  // Index of the first point farthest from exact; none if all equal exact. NaN counts as farther
  // than infinity.
  std::optional<std::size_t> farthest;
};

RampSummary summarize_ramp(const std::vector<Result::LevelPoint>& ramp);

// A sentence: "At most 0.0859 of a level from exact, inside the permitted band."
std::string describe(const RampSummary& summary);

// The open alternatives that the result's levels of detail follow, as distinct causes; none if some
// level follows no open alternative.
std::vector<std::string> open_causes_of_levels(const Result& result);

}  // namespace edgecase
