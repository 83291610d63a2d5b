// SPDX-License-Identifier: MIT
//
// The pixels within three edges, by walking.
//
// An edge function is linear in its sample: it grows by the same number from each pixel to the
// next, which is exact in integers. So each is evaluated once and then only added to. The samples
// of a row that are inside are consecutive, since three half-planes meet in a convex region, and
// the row ends with them. triangle_covers and its homogeneous form define the inside; this finds
// the same pixels faster.
#pragma once

#include <array>
#include <vector>

#include "exact/fixed.h"

namespace edgecase {

// The integers must be wide enough for the function at every sample of the walk and one step
// beyond.
template <class Integer>
struct WalkedEdge {
  Integer value = 0;    // at the sample of the walk's first pixel; positive inside
  Integer right = 0;    // its growth from one column to the next
  Integer up = 0;       // its growth from one row to the next
  bool is_own = false;  // samples on the edge are inside

  bool has_inside() const { return value > 0 || (value == 0 && is_own); }
};

// The edges start at the lower left pixel of `bounds`. Rows from the bottom, each from the left.
template <class Integer>
std::vector<PixelPosition> walk_edges(std::array<WalkedEdge<Integer>, 3> edges,
                                      const PixelBounds& bounds) {
  std::vector<PixelPosition> pixels;
  for (int y = bounds.y_min; y <= bounds.y_max; ++y) {
    auto [a, b, c] = edges;
    bool is_inside = false;
    for (int x = bounds.x_min; x <= bounds.x_max; ++x) {
      const bool was_inside = is_inside;
      is_inside = a.has_inside() && b.has_inside() && c.has_inside();
      if (is_inside) pixels.push_back({x, y});
      if (was_inside && !is_inside) break;
      for (WalkedEdge<Integer>* edge : {&a, &b, &c}) edge->value += edge->right;
    }
    for (WalkedEdge<Integer>& edge : edges) edge.value += edge.up;
  }
  return pixels;
}

}  // namespace edgecase
