// SPDX-License-Identifier: MIT
//
// Convex regions of the window as half planes, with whole numbers in units of 2^-16 pixels.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "exact/fixed.h"
#include "exact/pixel.h"

namespace edgecase {

// The points with normal_x x + normal_y y <= limit; normals of at most 2^31, limits of 2^62.
struct HalfPlane {
  std::int64_t normal_x = 0;
  std::int64_t normal_y = 0;
  Int128 limit = 0;
};

// A pixel, boundary included.
std::array<HalfPlane, 4> half_planes_of(PixelPosition pixel);

// The corners of what half planes share, which must be bounded: of each that is no multiple of
// 2^-16 the multiples around it. Empty where they share nothing.
std::vector<Point> corners_of(std::span<const HalfPlane> planes);

}  // namespace edgecase
