// SPDX-License-Identifier: MIT
//
// Steps of minimizing: each proposes simpler scenes to a Shrinking, and returns whether any was
// kept.
#pragma once

#include <optional>
#include <vector>

#include "search/minimize.h"

namespace edgecase {

// -------------------------------------------------------------------------------------- primitives

// Steps towards fewer primitives: removing draws, primitives and vertices of a strip, many at once
// first; splitting strips, loops and fans; joining similar draws.

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

// ------------------------------------------------------------------------------------------ target

// Steps towards a smaller target and a position near its origin. Scenes move by whole pixels only:
// anything on a pixel's centre, or between two points of a sub-pixel grid, stays so.

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

// ------------------------------------------------------------------------------------- coordinates

// Steps towards coordinates that are round, aligned and near to the origin. Vertices at one point
// move together, so that shared edges and ends stay shared.

// The distinct points of vertices in drawing order, without those of clip coordinates.
std::vector<Point> points_of(const Scene& scene);

// Moves every vertex at points[i] to places[i]; `points` is the result of points_of.
Scene with_points(const Scene& scene, const std::vector<Point>& points,
                  const std::vector<Point>& places);

// The multiples of 2^-bits next to a coordinate, the nearest first; only the number itself if it is
// one. `bits` from 0 to 16.
std::vector<Fixed> neighbours_on_grid(Fixed value, int bits);

// Moves all points at once to grids of 1, 1/2, ... pixel: to the nearest position, down, up.
bool round_all(Shrinking& shrinking);
// Then each point, and each x or y, with all the points that share it or without them.
bool round_each(Shrinking& shrinking);
// Sets a point's x or y to that of another.
bool align(Shrinking& shrinking);
// Moves values of x and y by whole pixels towards 0, alone or with all values beyond them.
bool draw_in(Shrinking& shrinking);
// Rounds depths between the planes.
bool round_depths(Shrinking& shrinking);

// ------------------------------------------------------------------------------------- grid search

// Grid search: for scenes of a few points whose coordinates stay fine.
//
// Rounding one coordinate at a time gets stuck if several must move together: a tie needs all of
// its numbers. So whole scenes on a coarse grid are tried: first those with all points next to
// their present positions, then those farther away, then any of the same size, from a generator
// that is the same on every machine.

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
