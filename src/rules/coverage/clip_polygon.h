// SPDX-License-Identifier: MIT
//
// A clipped triangle as a polygon (Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974):
// what most renderers make of it, and what latitude speaks of. Its vertices are quotients of
// integers without a bound, then rounded once to multiples of 2^-16 pixels.
#pragma once

#include <vector>

#include "exact/fixed.h"
#include "model/scene.h"
#include "rules/coverage/clip_volume.h"

namespace edgecase {

// What cuts beside w > 0.
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
  // Is it none of the triangle's own? Then how far off, in pixels, one part of the coordinates that
  // it was computed of may put it: see clip_polygon.
  bool made = false;
  Fixed error;
};

// The polygon's vertices in the triangle's order, at most nine; empty where nothing is left, or
// what is left has no area. `parts`: errors are 1 part in so many.
std::vector<ClipPolygonVertex> clip_polygon(const UnclippedTriangle& triangle,
                                            const ClipPlanes& planes, std::int64_t parts);

// What is seen of a triangle that reaches out of the clip volume, through its viewport.
std::vector<ClipPolygonVertex> seen_polygon(const ScenePrimitive& triangle, std::int64_t parts = 1);

// ---------------------------------------------------------------------------------------- latitude
//
// What ruling 42 lets a clipped triangle cover: a convex polygon whose vertices may move, seen
// through a viewport whose sides do not.

struct LoosePolygon {
  std::vector<Point> vertices;  // in either order; fewer than three: nothing is left
  Fixed reach;                  // each may move by less in x and in y; more than 0
  Viewport viewport;            // that it was cut at: edges along its sides stay
};

// May some move put the sample inside or on an edge, and may some put it outside or on an edge?
bool polygon_possibly_covered(const LoosePolygon& polygon, Point sample);
bool polygon_possibly_uncovered(const LoosePolygon& polygon, Point sample);

}  // namespace edgecase
