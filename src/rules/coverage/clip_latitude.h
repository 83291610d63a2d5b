// SPDX-License-Identifier: MIT
//
// What ruling 42 lets a clipped triangle cover: a convex polygon whose vertices may move, seen
// through a viewport whose sides do not.
#pragma once

#include <vector>

#include "exact/fixed.h"
#include "model/scene.h"

namespace edgecase {

struct LoosePolygon {
  std::vector<Point> vertices;  // in either order; fewer than three: nothing is left
  Fixed reach;                  // each may move by less in x and in y; more than 0
  Viewport viewport;            // that it was cut at: edges along its sides stay
};

// May some move put the sample inside or on an edge, and may some put it outside or on an edge?
bool polygon_possibly_covered(const LoosePolygon& polygon, Point sample);
bool polygon_possibly_uncovered(const LoosePolygon& polygon, Point sample);

}  // namespace edgecase
