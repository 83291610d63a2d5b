// SPDX-License-Identifier: MIT
//
// A clipped triangle as a polygon (Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974), the
// way of most renderers and the subject of the latitude. Its vertices are quotients of unbounded
// integers, rounded once to multiples of 2^-16 pixels.
#pragma once

#include <vector>

#include "exact/fixed.h"
#include "model/scene.h"
#include "rules/coverage/clip_volume.h"

namespace edgecase {

// The planes that clip, besides w > 0.
struct ClipPlanes {
  bool depth = true;  // near and far
  // Vertical and horizontal lines of the window, whole pixels.
  int left = 0;
  int bottom = 0;
  int right = 0;
  int top = 0;
};

struct ClipPolygonVertex {
  Point position;  // the nearest multiples of 2^-16
  // False for a vertex of the triangle. If true: how far, in pixels, one part of the coordinates of
  // its computation may put it off; see clip_polygon.
  bool made = false;
  Fixed error;
};

// The polygon's vertices in the triangle's order, at most nine; empty if nothing is left, or only
// something without area. `parts`: errors are 1 part in this number.
std::vector<ClipPolygonVertex> clip_polygon(const UnclippedTriangle& triangle,
                                            const ClipPlanes& planes, std::int64_t parts);

// The visible part of a triangle that reaches out of the clip volume, through its viewport.
std::vector<ClipPolygonVertex> seen_polygon(const ScenePrimitive& triangle, std::int64_t parts = 1);

// ---------------------------------------------------------------------------------------- latitude
//
// The area that ruling 42 permits a clipped triangle to cover: a convex polygon with movable
// vertices, seen through a viewport with fixed sides.

struct LoosePolygon {
  std::vector<Point> vertices;  // in either order; fewer than three: nothing is left
  Fixed reach;                  // each vertex may move by less than this in x and in y; more than 0
  Viewport viewport;            // whose sides cut it: edges along them do not move
};

// May some move put the sample inside or on an edge, and may some put it outside or on an edge?
bool polygon_possibly_covered(const LoosePolygon& polygon, Point sample);
bool polygon_possibly_uncovered(const LoosePolygon& polygon, Point sample);

}  // namespace edgecase
