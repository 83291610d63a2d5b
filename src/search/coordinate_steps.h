// SPDX-License-Identifier: MIT
//
// Steps towards coordinates that are round, aligned and near to the origin. Vertices at one point
// move together, so that edges and ends that are shared stay shared.
#pragma once

#include <vector>

#include "search/shrinking.h"

namespace edgecase {

// The points at which vertices lie, each once, in drawing order; those of clip coordinates left
// out.
std::vector<Point> points_of(const Scene& scene);

// Moves every vertex at points[i] to places[i]; both as points_of.
Scene with_points(const Scene& scene, const std::vector<Point>& points,
                  const std::vector<Point>& places);

// The multiples of 2^-bits next to a coordinate, the nearest first; the number itself alone, where
// it is one. `bits` from 0 to 16.
std::vector<Fixed> neighbours_on_grid(Fixed value, int bits);

// Each returns whether anything was kept.

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

}  // namespace edgecase
