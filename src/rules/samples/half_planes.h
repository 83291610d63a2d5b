// SPDX-License-Identifier: MIT
//
// Convex regions of the window: intersections of half planes.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "exact/fixed.h"

namespace edgecase {

// One half plane, in units of 2^-16 pixels: the points with normal_x x + normal_y y <= limit;
// normals up to 2^31, limits up to 2^62.
struct HalfPlane {
  std::int64_t normal_x = 0;
  std::int64_t normal_y = 0;
  Int128 limit = 0;
};

// A pixel, including its boundary.
std::array<HalfPlane, 4> half_planes_of(PixelPosition pixel);

// The corners of the intersection of half planes, which must be bounded. A corner that is no
// multiple of 2^-16 is replaced by the multiples around it. Empty if they do not intersect.
std::vector<Point> corners_of(std::span<const HalfPlane> planes);

}  // namespace edgecase
