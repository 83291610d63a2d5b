// SPDX-License-Identifier: MIT
//
// "expect" of a case file: the author's drawings of hits or coverage, and "when", the cases of the
// file to which each of them applies.
//
// Without "when" that is the base case without variants. {"dx": 0} means every combination with 0
// on the axis dx, whatever the other axes are, without variants; {"variant": "reverse"} means that
// image of each combination, named by its part of an id ("octant=3").
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
  Place place;                                              // of "when", or of its drawing
  bool given = false;                                       // if not, the base case
  std::vector<std::pair<std::size_t, std::size_t>> values;  // indices of axes and their values
  std::string variant;                                      // part of an id; "" without variants
};

// The conditions of all drawings in the list "expect", in order. The reader of drawings reports
// values of the wrong type.
std::vector<When> read_conditions(const Place& expect, const Sweep& sweep, const Variants& variants,
                                  Findings& findings);

// Whether a drawing applies to an image of a combination.
bool holds(const When& when, const Sweep& sweep, const Combination& combination,
           const Image& image);

// Reads `masks` of an expectation: the author's drawing of the samples covered in each pixel.
//
// Rows are strings, the top one first. Cells, one for each pixel, are separated by blanks: a mask
// in hexadecimal digits, with bit s for sample s, or "." for a pixel without covered samples.

// Reads `expect`: the author's drawings of hit pixels, in the case file or beside it, or of covered
// samples.
//
// Drawings are written as people see them, top row first, and stored bottom row first, since window
// coordinates have y up. A drawing in a separate file must lie inside the case's folder, even after
// links and ".." are resolved.

// One item of `expect`. `target` gives the size and the number of samples; 0 means unknown, and is
// not checked. `folder` is that of the case file. "when" is left to read_conditions.
Expect read_drawing(const Place& place, const Target& target, const std::filesystem::path& folder,
                    Findings& findings);

}  // namespace edgecase
