// SPDX-License-Identifier: MIT
//
// Steps of minimizing: each proposes simpler scenes to a Shrinking, and returns whether any was
// kept.
#pragma once

#include <optional>
#include <vector>

#include "search/shrinking.h"

namespace edgecase {

// -------------------------------------------------------------------------------------- primitives

// Towards fewer primitives: draws, primitives of a draw and vertices of a strip are left out, first
// many at once; strips, loops and fans become separate primitives; draws alike become one.

// The same primitives without shared vertices, each with its vertices in the order of assembly. A
// draw that has none already stays as it is.
Draw separated(const Scene& scene, std::size_t draw);

// The primitives that the find is on alone, then together with one other primitive each.
bool keep_only_finds(Shrinking& shrinking);
bool leave_out_draws(Shrinking& shrinking);
bool separate_primitives(Shrinking& shrinking);
// Primitives of a draw; of strips, loops and fans that stay, vertices.
bool leave_out_primitives(Shrinking& shrinking);
bool join_draws(Shrinking& shrinking);

// ------------------------------------------------------------------------------------------ target

// Steps towards a smaller target and a place near its origin. Scenes move by whole pixels only:
// what lies on a pixel's centre, or between two numbers of a sub-pixel grid, stays so.

// A distance in whole pixels, y up.
struct Move {
  int x = 0;
  int y = 0;
};

// All that is drawn, moved: vertices, scissors and, where the scene has one of its own, the
// viewport. None where vertices are given as clip coordinates.
std::optional<Scene> moved_scene(const Scene& scene, Move move);

// Columns and rows are cut away: right and top, then left and bottom, with what is drawn moved
// there. The pixels that the find is on stay.
bool crop_target(Shrinking& shrinking);
// Everything is moved towards the origin, the target staying as it is; powers of two first.
bool move_to_origin(Shrinking& shrinking);

// ------------------------------------------------------------------------------------- coordinates

// Steps towards coordinates that are round, aligned and near to the origin. Vertices at one point
// move together, so that edges and ends that are shared stay shared.

// The points at which vertices lie, each once, in drawing order; those of clip coordinates left
// out.
std::vector<Point> points_of(const Scene& scene);

// Moves every vertex at points[i] to places[i]; both as points_of.
Scene with_points(const Scene& scene, const std::vector<Point>& points,
                  const std::vector<Point>& places);

// The multiples of 2^-bits next to a coordinate, the nearest first; the number itself alone, where
// it is one. `bits` from 0 to 16.
std::vector<Fixed> neighbours_on_grid(Fixed value, int bits);

// All points at once go to grids of 1, 1/2, ... pixel: to the nearest place, down, up.
bool round_all(Shrinking& shrinking);
// Then each point, and each x or y, with all the points that share it or without.
bool round_each(Shrinking& shrinking);
// A point takes another's x or y.
bool align(Shrinking& shrinking);
// Values of x and of y move by whole pixels towards 0, by themselves or with all beyond them.
bool draw_in(Shrinking& shrinking);
// Depths between the planes.
bool round_depths(Shrinking& shrinking);

// ------------------------------------------------------------------------------------- grid search

// Grid search: for scenes of a few points whose coordinates stay fine.
//
// Rounding one coordinate at a time gets stuck where several must move together: a tie is only
// there when all of its numbers fit. So whole scenes on a coarse grid are asked: first those all of
// whose points are next to where they are now, then those farther off, then any that are as large,
// drawn from a generator that is the same on every machine.

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
