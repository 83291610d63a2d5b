// SPDX-License-Identifier: MIT
//
// Steps of minimizing towards coordinates that are round, aligned and near to the origin. Each
// proposes simpler scenes to a Shrinking, and returns whether any was kept. Vertices at one point
// move together, so that shared edges and ends stay shared.
#pragma once

#include <vector>

#include "model/scene.h"
#include "search/shrinking.h"

namespace edgecase {

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

}  // namespace edgecase
