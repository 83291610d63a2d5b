// SPDX-License-Identifier: MIT
//
// Points whose vertex is a quotient.
//
// The rule is that of point_ownership.h: a pixel's centre inside a square round the vertex. Here
// the vertex is (x/w, y/w), and every distance is taken w times as large, so that all of them are
// integers again and a centre on the boundary of the square is known to be there.
#pragma once

#include "exact/homogeneous.h"
#include "rules/coverage/point_ownership.h"

namespace edgecase {

// A point of a size above 0 and at most 64 pixels. The vertex's w is at most 2^35, as an offset
// makes it.
struct HomogeneousSizedPoint {
  HomogeneousPoint vertex;
  Fixed size;
};

// The vertex moved as an offset has it.
HomogeneousPoint moved(const HomogeneousPoint& vertex, PointOffset offset);

// Does the point's square hold the sample, or the centre of pixel (x, y)?
bool point_covers(const HomogeneousSizedPoint& point, Point sample, const TieRule& ties);
inline bool point_covers(const HomogeneousSizedPoint& point, int x, int y, const TieRule& ties) {
  return point_covers(point, pixel_centre(x, y), ties);
}

}  // namespace edgecase
