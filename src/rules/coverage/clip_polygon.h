// SPDX-License-Identifier: MIT
//
// A clipped triangle as a polygon (Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974):
// what most renderers make of it, and what latitude speaks of. Its vertices are quotients of
// integers without a bound, then rounded once to multiples of 2^-16 pixels.
#pragma once

#include <vector>

#include "exact/fixed.h"
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

}  // namespace edgecase
