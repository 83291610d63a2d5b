// SPDX-License-Identifier: MIT
//
// Grid search: for scenes of a few points whose coordinates stay fine.
//
// Rounding one coordinate at a time gets stuck if several must move together: a tie needs all of
// its numbers. So whole scenes on a coarse grid are tried: first those with all points next to
// their present positions, then those farther away, then any of the same size, from a generator
// that is the same on every machine.
#pragma once

#include <cstddef>

#include "search/shrinking.h"

namespace edgecase {

// The largest number of fraction bits in easily readable coordinates.
constexpr int kReadableBits = 4;
// Scenes of more points are not searched: there are too many of them.
constexpr std::size_t kMostGridPoints = 6;

// Tries all ways to move every point to a neighbour on grids of 1, 1/2, ... pixel that are coarser
// than the present one. Returns whether anything was kept.
bool search_neighbours(Shrinking& shrinking);

// Tries at most `most` scenes of kReadableBits whose points lie farther away. Returns whether
// anything was kept.
bool search_afar(Shrinking& shrinking, std::size_t most);

}  // namespace edgecase
