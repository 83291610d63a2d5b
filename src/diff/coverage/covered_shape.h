// SPDX-License-Identifier: MIT
//
// The shape of what a triangle covers. A triangle is convex, wherever its vertices are moved. What
// lies in the hull of pixel centres that it covers therefore lies in it, too: strictly inside, if
// it is strictly inside the hull, or else perhaps on an edge, together with covered centres on
// either side of it. So a hole needs no knowledge of how vertices were moved.
#pragma once

#include <span>
#include <vector>

#include "exact/fixed.h"

namespace edgecase {

// The pixels whose centres lie in the closed convex hull of some pixels' centres.
class PixelHull {
 public:
  // The pixels are sorted by row and column; one may occur several times.
  explicit PixelHull(std::span<const PixelPosition> pixels);

  bool contains(PixelPosition pixel) const;

  // Columns of one row, both inclusive; empty if first > last. Whether the hull's border passes
  // through the centres of these two.
  struct Columns {
    int first = 0;
    int last = -1;
    bool is_first_on_border = true;
    bool is_last_on_border = true;
  };
  int first_row() const { return first_row_; }
  std::span<const Columns> rows() const { return rows_; }

 private:
  int first_row_ = 0;
  std::vector<Columns> rows_;
};

// A pixel in the hull of others that is not among them.
struct Hole {
  PixelPosition pixel;
  bool is_on_border = false;  // of the hull; else strictly inside
};
// In the order of the pixels, which are sorted by row and column.
std::vector<Hole> holes_in(std::span<const PixelPosition> pixels);

}  // namespace edgecase
