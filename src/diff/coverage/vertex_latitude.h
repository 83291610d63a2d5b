// SPDX-License-Identifier: MIT
//
// How far vertices may move, as far as the specification leaves it open.
//
// Ruling 4 lets a vertex move by less than a step of the sub-pixel grid. A vertex whose w is not 1,
// or that is given as clip coordinates, also went through a division, a scaling and an addition,
// each of which may err (ruling 15). Points and triangles are judged by the sum of both; lines,
// which are read under one snap, by where that snap may put the erring vertex. A vertex given in
// the window with w = 1 was scaled and added to as well: points and triangles are judged by that
// error where it is larger than the step.
#pragma once

#include <array>

#include "exact/fixed.h"
#include "model/scene.h"
#include "rules/coverage/clip_polygon.h"
#include "rules/coverage/loose_segment.h"
#include "rules/coverage/window.h"

namespace edgecase {

// Ruling 15: how far a vertex may be off in x and in y, pixels; 0 if nothing is divided. Includes
// the rounding of a quotient to the nearest multiple of 2^-16.
Fixed division_error(const Vertex& vertex, Point position, const Viewport& viewport);

// The largest error of a primitive's vertices. For the visible part of a clipped triangle and for a
// cut line, this includes the vertices made by clipping, which are off by more (ruling 42).
Fixed division_error(const ScenePrimitive& primitive);

// Ruling 15 for vertices given in the window with w = 1: how far the scaling and the addition may
// put the farthest of them off, pixels; 0 if there is none.
Fixed scaling_error(const ScenePrimitive& primitive);

// Rulings 4 and 15 together: each vertex may move by less than this. `bits` as in ruling 4.
Fixed reach_of(const ScenePrimitive& primitive, int bits);

// The visible part of a clipped triangle, and how it may move (ruling 42).
LoosePolygon loose_polygon(const ScenePrimitive& triangle, int bits);

// How far each end of a line may be from where it is, pixels: by division, and by clipping.
using EndErrors = std::array<Fixed, 2>;
EndErrors end_errors(const ScenePrimitive& line);

// A line whose exact ends are snapped, and how far from there erring ends may be snapped.
LooseSegment snapped_segment(const ScenePrimitive& line, Snap snap, const EndErrors& errors);

// True if two vertices have the same numbers, so that whatever happens to one happens to the other.
bool is_bit_identical(const Vertex& a, const Vertex& b);

}  // namespace edgecase
