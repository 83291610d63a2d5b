// SPDX-License-Identifier: MIT
//
// Grid joints: two lines that meet, between points of a coarse grid.
//
// There are too many of them for a list of all (see generate/grid_lines.h for lines alone), but
// what joints show with fine coordinates is found here with ones that people read.
#pragma once

#include <cstdint>

#include "model/scene.h"

namespace edgecase {

inline constexpr int kGridJointsOfScene = 16;

// So many pairs of lines, in one draw: the first of a pair ends where the second starts. All points
// are multiples of 1/16 strictly inside a target of 16x16 pixels; half of the joints lie at
// multiples of 1/2, where ends are ties mostly. In one of four scenes lines are half a pixel wide,
// which are drawn as wide as a pixel.
Scene grid_joint_scene(std::uint64_t seed, Surface surface, std::uint64_t index);

}  // namespace edgecase
