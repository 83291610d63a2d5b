// SPDX-License-Identifier: MIT
#include "rules/coverage/clip_volume.h"

#include <algorithm>

#include "exact/rational.h"
#include "rules/coverage/homogeneous_triangle.h"

namespace edgecase {
namespace {

bool all_in_front(const UnclippedTriangle& triangle) {
  return std::ranges::all_of(triangle.positions, [](const HomogeneousPoint& p) { return p.w > 0; });
}

// Is there a vertex nearer than near or farther than far, or behind the eye?
bool leaves_depth(const UnclippedTriangle& triangle) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t w = triangle.positions[i].w;
    if (w <= 0 || triangle.z[i] < -w || triangle.z[i] > w) return true;
  }
  return false;
}

// With e_i the determinant of the two other vertices and the sample, and e that of all three:
// b_i = e_i / e, and the sample's own w is what -1 and 1 are measured by. An e_i is below 2^111 and
// a z at most 2^33; e is below 2^127 and a sample's w at most 2^16.
bool lies_between_near_and_far(const UnclippedTriangle& triangle, const HomogeneousPoint& sample) {
  const auto& v = triangle.positions;
  Int256 area = cross(v[0], v[1], v[2]);
  Int256 depth = 0;
  for (std::size_t i = 0; i < 3; ++i)
    depth += Int256(cross(v[(i + 1) % 3], v[(i + 2) % 3], sample)) * triangle.z[i];
  const Int256 limit = abs(area) * sample.w;
  return abs(depth) <= limit;
}

HomogeneousPoint sample_of(PixelPosition pixel, Point within) {
  if (within == centre_of_pixel()) return homogeneous_centre(pixel.x, pixel.y);
  return homogeneous(place_in(pixel, within));
}

}  // namespace

bool clipped_triangle_covers(const UnclippedTriangle& triangle, const HomogeneousPoint& sample,
                             const TieRule& ties, bool depth) {
  if (!triangle_covers(triangle.positions, sample, ties)) return false;
  return !depth || !leaves_depth(triangle) || lies_between_near_and_far(triangle, sample);
}

bool is_in_viewport(const HomogeneousPoint& sample, const Viewport& viewport) {
  const auto between = [&](std::int64_t at, int low, int size) {
    return at >= low * sample.w && at <= (std::int64_t{low} + size) * sample.w;
  };
  return between(sample.x, viewport.x, viewport.width) &&
         between(sample.y, viewport.y, viewport.height);
}

std::vector<PixelPosition> clipped_triangle_pixels(const UnclippedTriangle& triangle,
                                                   const Viewport& viewport,
                                                   const PixelBounds& bounds, const TieRule& ties,
                                                   Point within, bool depth) {
  PixelBounds some = common_part(bounds, pixels_in(viewport));
  // Only what lies in front of the eye is where its quotients say.
  if (all_in_front(triangle)) some = sample_bounds(nearest_triangle(triangle.positions), some);
  std::vector<PixelPosition> pixels;
  for (int y = some.y_min; y <= some.y_max; ++y)
    for (int x = some.x_min; x <= some.x_max; ++x)
      if (clipped_triangle_covers(triangle, sample_of({x, y}, within), ties, depth))
        pixels.push_back({x, y});
  return pixels;
}

Rule clip_volume_rule() {
  return {
      RuleId::clip_volume,
      "Only the part of a primitive in the clip volume is drawn",
      "13.7 (primitive clipping)",
      "new vertices are rounded and may be moved as others are; points outside the sides of the "
      "view volume may be drawn or not (ruling 42)",
      "homogeneous",
      alternatives_of<ClipMethod>(),
      {{42,
        "A clipped triangle is a polygon: that part of the triangle for which -w <= z <= w, seen "
        "through the viewport. Each of its vertices may be moved by less than the step of ruling 4 "
        "and by what its computation may be off (ruling 15); of a vertex that clipping made, 1 "
        "part "
        "in 10^5 of the coordinates of the two vertices between which it lies, divided by its w. A "
        "sample may be drawn if some such move puts it inside or on an edge, and left out if some "
        "such move puts it outside or on an edge. Beyond the viewport's sides no sample is drawn. "
        "What a fragment of it carries may be the value at any place within reach of such moves. "
        "Of a line the segment is drawn that lies in the volume; an end that clipping made may be "
        "off likewise, and the rulings on lines speak of that segment. A point is drawn where its "
        "vertex lies in the volume, its border included. Where the vertex lies between near and "
        "far, but outside the volume's other sides, the point is drawn under ruling 6 or "
        "discarded, "
        "as the implementation likes; exact discards it. Elsewhere nothing is drawn of it, however "
        "large it is. Where clipping makes more than three edges, a fragment's colour may be any "
        "mean of what the polygon's vertices carry (14.6.1), which lies between those of the "
        "triangle's."},
       {44,
        "The depth of a fragment of a clipped polygon lies on the triangle's plane (equation "
        "14.10), and not only between the least and the greatest of the polygon's vertices."},
       {54,
        "Points and lines have fragments beyond the viewport's sides, wherever their square or "
        "their width reaches into the framebuffer."}}};
}

}  // namespace edgecase
