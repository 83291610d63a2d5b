// SPDX-License-Identifier: MIT
#include "kernels/covered_pixels_kernel.h"

#include "kernels/line_walk.h"
#include "kernels/pixel_plane.h"
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

bool walks_just(std::span<const PixelPosition> pixels, const Triangle& triangle,
                const PixelBounds& bounds, const TieRule& ties) {
  const TriangleSetup setup(raw_point(triangle[0]), raw_point(triangle[1]), raw_point(triangle[2]),
                            weights_of(ties));
  const PixelBounds box = common_part(setup.box_at(kCentrePlace), bounds);
  if (!setup.has_area() || is_empty(box)) return pixels.empty();
  // Sorted pixels equal a span if its first pixel, last pixel and count agree.
  std::size_t at = 0;
  bool is_same = true;
  walk_spans(setup.edges_at(kCentrePlace), box, [&](int y, int first, int last) {
    const auto count = static_cast<std::size_t>(last - first + 1);
    is_same = is_same && count <= pixels.size() - at && pixels[at] == PixelPosition{first, y} &&
              pixels[at + count - 1] == PixelPosition{last, y};
    if (is_same) at += count;
  });
  return is_same && at == pixels.size();
}

std::vector<PixelPosition> walked_tied_pixels(const Triangle& triangle, const PixelBounds& bounds) {
  struct Span {
    int y, first, last;
  };
  const auto spans_of = [&](std::int64_t owned) {
    std::vector<Span> spans;
    const TriangleSetup setup(raw_point(triangle[0]), raw_point(triangle[1]),
                              raw_point(triangle[2]), {0, 0, owned});
    const PixelBounds box = common_part(setup.box_at(kCentrePlace), bounds);
    if (!setup.has_area() || is_empty(box)) return spans;
    walk_spans(setup.edges_at(kCentrePlace), box, [&](int y, int first, int last) {
      spans.push_back({y, first, last});
    });
    return spans;
  };
  const std::vector<Span> open = spans_of(0);
  std::vector<PixelPosition> pixels;
  auto inner = open.begin();
  for (const Span& outer : spans_of(1)) {
    while (inner != open.end() && inner->y < outer.y) ++inner;
    const bool has_inner = inner != open.end() && inner->y == outer.y;
    for (int x = outer.first; x <= outer.last; ++x) {
      if (has_inner && x == inner->first) x = inner->last + 1;
      if (x <= outer.last) pixels.push_back({x, outer.y});
    }
  }
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

void fill_lines(const FillTarget& target, std::span<const FlatLine> lines, const TieWeights& ties) {
  const PixelPlane plane = target.planes[0];
  for (const FlatLine& line : lines)
    walk_line(line.a, line.b, ties, target.bounds,
              [&](int x, int y) { plane.row(y)[x] = line.color; });
}

}  // namespace edgecase
