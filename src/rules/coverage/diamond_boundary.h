// SPDX-License-Identifier: MIT
//
// Whom the boundary of a line's diamond belongs to.
//
// OpenGL avoids the question: it moves the endpoints by an infinitesimal, and boundaries are never
// hit (a perturbed tie rule). Direct3D and some courses answer it instead: some of the diamond's
// four edges (without their ends) and four corners count as inside, in Direct3D other ones for
// x-major than for y-major lines.
#pragma once

#include <span>
#include <string_view>

#include "rules/coverage/tie_rule.h"

namespace edgecase {

// Parts of the boundary, y up, as bits of a set.
enum DiamondPart : unsigned {
  kLeftCorner = 1u << 0,
  kRightCorner = 1u << 1,
  kBottomCorner = 1u << 2,
  kTopCorner = 1u << 3,
  kLowerLeftEdge = 1u << 4,
  kLowerRightEdge = 1u << 5,
  kUpperLeftEdge = 1u << 6,
  kUpperRightEdge = 1u << 7,
};

struct DiamondBoundary {
  std::string_view name;
  // Set: ties are decided by moving the diamond, or by all-open or all-closed boundaries.
  const TieRule* ties = nullptr;
  // Otherwise: the parts that count as inside, for x-major and for y-major segments.
  unsigned x_major_parts = 0;
  unsigned y_major_parts = 0;
};

// The ten tie rules, then "direct3d" and "scotty3d".
std::span<const DiamondBoundary> all_diamond_boundaries();

// Null when there is none of that name.
const DiamondBoundary* find_diamond_boundary(std::string_view name);

}  // namespace edgecase
