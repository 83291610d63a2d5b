// SPDX-License-Identifier: MIT
#include "kernels/covered_pixels_kernel.h"

#include "kernels/line_walk.h"
#include "kernels/span_walk.h"

namespace edgecase {

std::vector<PixelPosition> walked_triangle_pixels(const Triangle& triangle,
                                                  const PixelBounds& bounds, const TieRule& ties) {
  std::vector<PixelPosition> pixels;
  const TriangleSetup setup(raw_point(triangle[0]), raw_point(triangle[1]), raw_point(triangle[2]),
                            weights_of(ties));
  const PixelBounds box = common_part(setup.box_at(kCentrePlace), bounds);
  if (!setup.has_area() || is_empty(box)) return pixels;
  walk_spans(setup.edges_at(kCentrePlace), box, [&](int y, int first, int last) {
    for (int x = first; x <= last; ++x) pixels.push_back({x, y});
  });
  return pixels;
}

std::vector<PixelPosition> walked_line_pixels(const Segment& segment, const PixelBounds& bounds,
                                              const TieRule& ties) {
  std::vector<PixelPosition> pixels;
  walk_line(raw_point(segment.a), raw_point(segment.b), weights_of(ties), bounds,
            [&](int x, int y) {
              pixels.push_back({x, y});
            });
  return pixels;
}

}  // namespace edgecase
