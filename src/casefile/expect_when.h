// SPDX-License-Identifier: MIT
//
// Which of a file's cases a drawing holds for: its "when".
//
// Without "when" it is the base case without variants. {"dx": 0} means every combination whose
// axis dx is 0, whatever the other axes are, without variants; {"variant": "reverse"} that image
// of each combination, named by its part of an id ("octant=3").
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "casefile/sweep.h"
#include "casefile/variants.h"

namespace edgecase {

struct When {
  Place place;                                              // of the "when", or of its drawing
  bool given = false;                                       // else: the base case
  std::vector<std::pair<std::size_t, std::size_t>> values;  // axis and its value, by index
  std::string variant;                                      // part of an id, "" without variants
};

// The conditions of all drawings in the list "expect", in its order. What is no list or no object
// is left to the reader of drawings.
std::vector<When> read_conditions(const Place& expect, const Sweep& sweep, const Variants& variants,
                                  Findings& findings);

// Does a drawing hold for an image of a combination?
bool holds(const When& when, const Sweep& sweep, const Combination& combination,
           const Image& image);

}  // namespace edgecase
