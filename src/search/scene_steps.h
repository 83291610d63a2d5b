// SPDX-License-Identifier: MIT
//
// Steps of minimizing towards fewer primitives, a smaller target and a position near its origin.
// Each proposes simpler scenes to a Shrinking, and returns whether any was kept.
//
// Draws, primitives and vertices of a strip are removed, many at once first; strips, loops and fans
// are split, and similar draws joined. Scenes move by whole pixels only: anything on a pixel's
// centre, or between two points of a sub-pixel grid, stays so.
#pragma once

#include <cstddef>
#include <optional>

#include "model/scene.h"
#include "search/shrinking.h"

namespace edgecase {

// The same primitives without shared vertices, each with its vertices in the order of assembly. A
// draw without shared vertices is returned unchanged.
Draw separated(const Scene& scene, std::size_t draw);

// Keeps only the find's primitives, or these together with one other primitive each.
bool keep_only_finds(Shrinking& shrinking);
bool leave_out_draws(Shrinking& shrinking);
bool separate_primitives(Shrinking& shrinking);
// Removes primitives of a draw, or vertices of remaining strips, loops and fans.
bool leave_out_primitives(Shrinking& shrinking);
bool join_draws(Shrinking& shrinking);

// A distance in whole pixels, y up.
struct Move {
  int x = 0;
  int y = 0;
};

// Moves everything that is drawn: vertices, scissors and, if the scene has its own, the viewport.
// Nothing if vertices are given as clip coordinates.
std::optional<Scene> moved_scene(const Scene& scene, Move move);

// Removes columns and rows: right and top, then left and bottom, with the drawing moved there. The
// find's pixels stay.
bool crop_target(Shrinking& shrinking);
// Moves everything towards the origin without changing the target; powers of two first.
bool move_to_origin(Shrinking& shrinking);

}  // namespace edgecase
