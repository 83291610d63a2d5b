// SPDX-License-Identifier: MIT
//
// Reads `masks` of an expectation: the author's drawing of which samples of each pixel are covered.
//
// Rows are strings, the top one first; their cells, one for each pixel, are separated by blanks: a
// mask in hexadecimal digits, bit s for sample s, or "." for a pixel of which no sample is covered.
#pragma once

#include <cstdint>
#include <vector>

#include "casefile/fields.h"
#include "model/scene.h"

namespace edgecase {

// Masks row by row from the bottom. A size or number of samples of the target that is 0 is not
// known, and not checked.
std::vector<std::uint32_t> read_masks(const Place& place, const Target& target, Findings& findings);

}  // namespace edgecase
