// SPDX-License-Identifier: MIT
//
// A clipped triangle as a polygon (Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974), the
// way of most renderers and the subject of the latitude. Its vertices are quotients of unbounded
// integers, rounded once to multiples of 2^-16 pixels.
//
// The area that ruling 42 permits a clipped triangle to cover: a convex polygon with movable
// vertices, seen through a viewport with fixed sides.
#pragma once

#include <cstdint>
#include <vector>

#include "exact/fixed.h"
#include "model/scene.h"
#include "rules/coverage/clip_volume.h"

namespace edgecase {

// The planes that clip, besides w > 0.
struct ClipPlanes {
  bool depth;  // near and far
  // Vertical and horizontal lines of the window, half pixels.
  int left;
  int bottom;
  int right;
  int top;
};

// The viewport's own sides; those of a clip volume twice as wide and high round the same middle;
// and sides as far away as exact coordinates reach, 8192 pixels.
constexpr ClipPlanes sides_of(const Viewport& v) {
  return {true, 2 * v.x, 2 * v.y, 2 * (v.x + v.width), 2 * (v.y + v.height)};
}
constexpr ClipPlanes doubled_sides_of(const Viewport& v) {
  return {true, 2 * v.x - v.width, 2 * v.y - v.height, 2 * v.x + 3 * v.width,
          2 * v.y + 3 * v.height};
}
constexpr ClipPlanes guard_band() {
  constexpr int kHalves = 2 * static_cast<int>(Fixed::kMaxCoordinate);
  return {true, -kHalves, -kHalves, kHalves, kHalves};
}

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

struct LoosePolygon {
  std::vector<Point> vertices;  // in either order; fewer than three: nothing is left
  Fixed reach;                  // each vertex may move by less than this in x and in y; more than 0
  Viewport viewport;            // whose sides cut it: edges along them do not move
};

// Whether the edge from a to b lies along a side of the viewport.
bool is_on_viewport(Point a, Point b, const Viewport& viewport);

// May some move put the sample inside or on an edge, and may some put it outside or on an edge?
bool polygon_possibly_covered(const LoosePolygon& polygon, Point sample);
bool polygon_possibly_uncovered(const LoosePolygon& polygon, Point sample);

}  // namespace edgecase
