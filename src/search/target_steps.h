// SPDX-License-Identifier: MIT
//
// Steps towards a smaller target and a place near its origin. Scenes move by whole pixels only:
// what lies on a pixel's centre, or between two numbers of a sub-pixel grid, stays so.
#pragma once

#include <optional>

#include "search/shrinking.h"

namespace edgecase {

// A distance in whole pixels, y up.
struct Move {
  int x = 0;
  int y = 0;
};

// All that is drawn, moved: vertices, scissors and, where the scene has one of its own, the
// viewport. None where vertices are given as clip coordinates.
std::optional<Scene> moved_scene(const Scene& scene, Move move);

// Each returns whether anything was kept.

// Columns and rows are cut away: right and top, then left and bottom, with what is drawn moved
// there. The pixels that the find is on stay.
bool crop_target(Shrinking& shrinking);
// Everything is moved towards the origin, the target staying as it is; powers of two first.
bool move_to_origin(Shrinking& shrinking);

}  // namespace edgecase
