// SPDX-License-Identifier: MIT
//
// Grid search: for scenes of a few points whose coordinates stay fine.
//
// Rounding one coordinate at a time gets stuck where several must move together: a tie is only
// there when all of its numbers fit. So whole scenes on a coarse grid are asked: first those all of
// whose points are next to where they are now, then those farther off, then any that are as large,
// drawn from a generator that is the same on every machine.
#pragma once

#include "search/shrinking.h"

namespace edgecase {

// Coordinates of at most so many fraction bits are what people read at a glance.
constexpr int kReadableBits = 4;
// Scenes of more points are not searched for: there are too many of them.
constexpr std::size_t kMostGridPoints = 6;

// All ways to move every point to a neighbour on grids of 1, 1/2, ... pixel, up to one that is
// coarser than the present one. Returns whether anything was kept.
bool search_neighbours(Shrinking& shrinking);

// Scenes of kReadableBits whose points lie farther off, at most `most` of them. Returns whether
// anything was kept.
bool search_afar(Shrinking& shrinking, std::size_t most);

}  // namespace edgecase
