// SPDX-License-Identifier: MIT
#include "kernels/line_walk.h"
#include "kernels/pixel_plane.h"

namespace edgecase {

void fill_lines(const FillTarget& target, std::span<const FlatLine> lines, const TieWeights& ties) {
  const PixelPlane plane = target.planes[0];
  for (const FlatLine& line : lines)
    walk_line(line.a, line.b, ties, target.bounds,
              [&](int x, int y) { plane.row(y)[x] = line.color; });
}

}  // namespace edgecase
