// SPDX-License-Identifier: MIT
//
// Where vertices may lie, as far as the specification leaves it open.
//
// Ruling 4 lets a vertex move by less than a step of the sub-pixel grid. A vertex whose w is not 1,
// or that is given as clip coordinates, has come to the window by a division, a scaling and an
// addition besides, each of which may err (ruling 15). Points and triangles are judged by the sum
// of both; lines, which are read under one snap, by where that snap may put the vertex that erred.
#pragma once

#include "model/scene.h"
#include "rules/coverage/clip_polygon.h"
#include "rules/coverage/line_latitude.h"
#include "rules/coverage/snap.h"

namespace edgecase {

// Ruling 15: how far off a vertex may be in x and in y, pixels; 0 where nothing is divided. It
// holds the rounding of a quotient to the nearest multiple of 2^-16 too.
Fixed division_error(const Vertex& vertex, Point position, const Viewport& viewport);

// The largest of those of a primitive's vertices. Of what is seen of a clipped triangle and of a
// cut line, of the vertices that clipping makes too, which are off by more (ruling 42).
Fixed division_error(const ScenePrimitive& primitive);

// Rulings 4 and 15 together: each vertex may move by less than this. `bits` as in ruling 4.
Fixed reach_of(const ScenePrimitive& primitive, int bits);

// What is seen of a clipped triangle, and how it may move (ruling 42).
LoosePolygon loose_polygon(const ScenePrimitive& triangle, int bits);

// A line whose exact ends are snapped, and how far from there ends that erred may be snapped to.
LooseSegment snapped_segment(const ScenePrimitive& line, Snap snap);

// Are two vertices given by the same numbers, so that whatever is done to one is done to the other?
bool is_bit_identical(const Vertex& a, const Vertex& b);

// ------------------------------------------------------------------------------------------ facing
//
// Ruling 40: which ways a triangle may face, where moves of its vertices within rulings 4 and 15
// can turn it round, or its area before clipping has another sign than that of what is seen.

// Never neither.
struct FacingLatitude {
  bool may_face_front = true;
  bool may_face_back = false;
};

// `bits` as in ruling 4. Points and lines face the front.
FacingLatitude permitted_facing(const ScenePrimitive& primitive, int bits);

// Of a primitive: may it be dropped, may it be drawn, as its draw culls?
struct CullingLatitude {
  bool may_be_culled = false;
  bool may_be_drawn = true;
};
CullingLatitude permitted_culling(const ScenePrimitive& primitive, int bits);

}  // namespace edgecase
