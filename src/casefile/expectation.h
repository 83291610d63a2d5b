// SPDX-License-Identifier: MIT
//
// "expect" of a case file: the author's drawings of what is hit or covered, and which of the file's
// cases each of them holds for, its "when".
//
// Without "when" it is the base case without variants. {"dx": 0} means every combination whose
// axis dx is 0, whatever the other axes are, without variants; {"variant": "reverse"} that image
// of each combination, named by its part of an id ("octant=3").
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "casefile/json/fields.h"
#include "casefile/sweep/sweep.h"
#include "casefile/sweep/variants.h"
#include "model/case.h"
#include "model/scene.h"

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

// Reads `masks` of an expectation: the author's drawing of which samples of each pixel are covered.
//
// Rows are strings, the top one first; their cells, one for each pixel, are separated by blanks: a
// mask in hexadecimal digits, bit s for sample s, or "." for a pixel of which no sample is covered.

// Masks row by row from the bottom. A size or number of samples of the target that is 0 is not
// known, and not checked.
std::vector<std::uint32_t> read_masks(const Place& place, const Target& target, Findings& findings);

// Reads `expect`: the author's drawings of which pixels are hit, in the case file or beside it,
// or which samples are covered.
//
// Drawings are written as people see them, top row first, and stored bottom row first, since window
// coordinates have y up. A drawing in a file of its own must lie inside the case's folder, whatever
// links and ".." say.

// One item of `expect`. `target` gives the wanted size and the number of samples; what is 0 is not
// known, and not checked. `folder` is the case file's. Its "when" is left to read_conditions.
Expect read_drawing(const Place& place, const Target& target, const std::filesystem::path& folder,
                    Findings& findings);

}  // namespace edgecase
