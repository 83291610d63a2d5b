// SPDX-License-Identifier: MIT
#include "diff/values/vertex_latitude.h"

#include <algorithm>
#include <cstdlib>

namespace edgecase {
namespace {

// "About 1 part in 10^5" (GL 4.6 core, 2.3.1).
constexpr std::int64_t kParts = 100000;

// Of one coordinate, raw: the division and the scaling err by a part of the distance from the
// viewport's centre each, the addition of the centre by a part of the sum. One raw unit more holds
// the rounding of the coordinate, half a unit at most, and the products of errors, less than 3
// parts in 10^10 of 2^13 pixels each.
std::int64_t error_of_coordinate(Fixed at, int low, int size) {
  const std::int64_t centre = (2 * std::int64_t{low} + size) * (Fixed::kOne / 2);
  const std::int64_t parts = 2 * std::abs(at.raw() - centre) + std::abs(at.raw());
  return (parts + kParts - 1) / kParts + 1;
}

// How far the grid line of one coordinate may be from where the exact coordinate is snapped to.
Fixed snapped_error(Snap snap, Fixed exact, Fixed nearest, Fixed error) {
  return std::max(snap(nearest + error) - exact, exact - snap(nearest - error));
}

}  // namespace

Fixed division_error(const Vertex& vertex, Point position, const Viewport& viewport) {
  if (!vertex.clip && vertex.w == 1) return {};
  return Fixed::from_raw(std::max(error_of_coordinate(position.x, viewport.x, viewport.width),
                                  error_of_coordinate(position.y, viewport.y, viewport.height)));
}

Fixed division_error(const ScenePrimitive& primitive, const Viewport& viewport) {
  Fixed largest;
  for (std::size_t i = 0; i < static_cast<std::size_t>(vertices_of(primitive.kind)); ++i)
    largest = std::max(largest, division_error(*primitive.vertices[i],
                                               nearest_point(primitive.positions[i]), viewport));
  return largest;
}

Fixed reach_of(const ScenePrimitive& primitive, const Viewport& viewport, int bits) {
  return grid_step(bits) + division_error(primitive, viewport);
}

LooseSegment snapped_segment(const ScenePrimitive& line, Snap snap, const Viewport& viewport) {
  LooseSegment result{{snap(line.positions[0]), snap(line.positions[1])}, {}};
  const Point* ends[] = {&result.segment.a, &result.segment.b};
  for (std::size_t i = 0; i < 2; ++i) {
    const Point nearest = nearest_point(line.positions[i]);
    const Fixed error = division_error(*line.vertices[i], nearest, viewport);
    if (error == Fixed()) continue;
    result.reach = std::max({result.reach, snapped_error(snap, ends[i]->x, nearest.x, error),
                             snapped_error(snap, ends[i]->y, nearest.y, error)});
  }
  return result;
}

bool is_bit_identical(const Vertex& a, const Vertex& b) {
  if (a.clip || b.clip) return a.clip == b.clip;
  return a.position == b.position && a.w == b.w;
}

}  // namespace edgecase
