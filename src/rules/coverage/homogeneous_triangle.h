// SPDX-License-Identifier: MIT
//
// Triangles whose vertices are quotients.
//
// An edge function is the determinant of three points with their w as third coordinates: its sign
// is known without a division (Olano and Greer, "Triangle Scan Conversion using 2D Homogeneous
// Coordinates", 1997). All w are positive here, so the determinant has the sign of the divided
// triangle's, and its growth to the right and up is the edge's normal, times a positive number.
// Ties are as in triangle_fill.h.
#pragma once

#include <array>
#include <vector>

#include "exact/fixed.h"
#include "exact/homogeneous.h"
#include "model/sampling.h"
#include "rules/coverage/tie_rule.h"
#include "rules/coverage/triangle_algorithm.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {

using HomogeneousTriangle = std::array<HomogeneousPoint, 3>;

// The nearest triangle whose coordinates are multiples of 2^-16.
Triangle nearest_triangle(const HomogeneousTriangle& triangle);

// True if the triangle covers the sample, or the centre of pixel (x, y). A sample's w is at most
// 2^16.
bool triangle_covers(const HomogeneousTriangle& triangle, const HomogeneousPoint& sample,
                     const TieRule& ties);
inline bool triangle_covers(const HomogeneousTriangle& triangle, int x, int y,
                            const TieRule& ties) {
  return triangle_covers(triangle, homogeneous_centre(x, y), ties);
}

// The pixels within `bounds` whose sample, at position `within`, is covered; each once, in no
// particular order. Algorithms that round use the nearest triangle.
std::vector<PixelPosition> triangle_pixels(const HomogeneousTriangle& triangle,
                                           const PixelBounds& bounds, TriangleAlgorithm algorithm,
                                           const TieRule& ties, Point within = centre_of_pixel());

}  // namespace edgecase
