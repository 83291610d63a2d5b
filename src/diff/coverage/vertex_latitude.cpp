// SPDX-License-Identifier: MIT
#include "diff/coverage/vertex_latitude.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "exact/rational.h"
#include "model/clipped_line.h"

namespace edgecase {
namespace {

// "About 1 part in 10^5" (GL 4.6 core, 2.3.1).
constexpr std::int64_t kParts = 100000;

// Whether a coordinate is divided by w before it is scaled. With w = 1 it is as it was: 2.3.4.1 has
// 1 x = x.
enum class Division { by_one, by_w };

// For one coordinate, raw: the division and the scaling each err by a part of the distance from the
// viewport's centre, the addition of the centre by a part of the sum. One more raw unit covers the
// rounding of the coordinate, half a unit at most, and the products of errors, less than 3 parts in
// 10^10 of 2^13 pixels each.
std::int64_t error_of_coordinate(Fixed at, int low, int size, Division division) {
  const std::int64_t centre = (2 * std::int64_t{low} + size) * (Fixed::kOne / 2);
  const std::int64_t operations = division == Division::by_w ? 2 : 1;
  const std::int64_t parts = operations * std::abs(at.raw() - centre) + std::abs(at.raw());
  return (parts + kParts - 1) / kParts + 1;
}

// How far the grid line of one coordinate may be from the one that exact snaps to.
Fixed snapped_error(Snap snap, Fixed exact, Fixed nearest, Fixed error) {
  return std::max(snap(nearest + error) - exact, exact - snap(nearest - error));
}

Fixed error_of_position(Point at, const Viewport& viewport, Division division = Division::by_w) {
  return Fixed::from_raw(
      std::max(error_of_coordinate(at.x, viewport.x, viewport.width, division),
               error_of_coordinate(at.y, viewport.y, viewport.height, division)));
}

// A vertex made by clipping is divided as the others are, and has the further error of its making.
Fixed error_of_seen(const ScenePrimitive& triangle) {
  Fixed largest;
  for (const ClipPolygonVertex& vertex : seen_polygon(triangle, kParts))
    largest =
        std::max(largest, error_of_position(vertex.position, triangle.viewport) + vertex.error);
  return largest;
}

// The end of a line made by clipping is a mean of the vertices: each of its coordinates errs by a
// part of the larger vertex' own, and so does w, by which they are divided.
Fixed error_of_cut(const ScenePrimitive& line, std::size_t end) {
  const RationalClip from = rational_clip(*line.vertices[0], line.viewport);
  const RationalClip to = rational_clip(*line.vertices[1], line.viewport);
  const auto part = visible_part(from, to, line.clips_sides);
  if (!part) return {};
  const Rational& t = end == 0 ? part->from : part->to;
  if (t == 0 || t == 1) return {};
  const auto largest = [&](const RationalClip& clip, const Rational& share) {
    const Viewport& v = line.viewport;
    const Rational x = v.x * clip.w + v.width * (clip.x + clip.w) / 2;
    const Rational y = v.y * clip.w + v.height * (clip.y + clip.w) / 2;
    return Rational(share * std::max({Rational(abs(x)), Rational(abs(y)), Rational(abs(clip.w))}));
  };
  const Rational sources = std::max(largest(from, 1 - t), largest(to, t));
  const Rational pixels = 2 * sources / (between(from, to, t).w * kParts);
  const Integer raw = floor_of(Rational(pixels * Fixed::kOne)) + 2;
  const std::int64_t limit = 2 * Fixed::kMaxCoordinate * Fixed::kOne;
  return Fixed::from_raw(static_cast<std::int64_t>(std::min<Integer>(raw, limit)));
}

// For one vertex of a primitive, or the vertex that replaces it.
Fixed error_of_vertex(const ScenePrimitive& primitive, std::size_t i) {
  const Point position = nearest_point(primitive.positions[i]);
  if (!primitive.is_cut)
    return division_error(*primitive.vertices[i], position, primitive.viewport);
  return error_of_position(position, primitive.viewport) + error_of_cut(primitive, i);
}

}  // namespace

Fixed division_error(const Vertex& vertex, Point position, const Viewport& viewport) {
  if (!vertex.clip && vertex.w == 1) return {};
  return error_of_position(position, viewport);
}

Fixed division_error(const ScenePrimitive& primitive) {
  if (primitive.is_clipped)
    return primitive.kind == PrimitiveKind::triangle ? error_of_seen(primitive) : Fixed();
  Fixed largest;
  for (std::size_t i = 0; i < static_cast<std::size_t>(vertices_of(primitive.kind)); ++i)
    largest = std::max(largest, error_of_vertex(primitive, i));
  return largest;
}

Fixed scaling_error(const ScenePrimitive& primitive) {
  if (primitive.is_clipped || primitive.is_cut) return {};
  Fixed largest;
  for (std::size_t i = 0; i < static_cast<std::size_t>(vertices_of(primitive.kind)); ++i) {
    const Vertex& vertex = *primitive.vertices[i];
    if (vertex.clip || vertex.w != 1) continue;
    largest = std::max(largest, error_of_position(nearest_point(primitive.positions[i]),
                                                  primitive.viewport, Division::by_one));
  }
  return largest;
}

Fixed reach_of(const ScenePrimitive& primitive, int bits) {
  return std::max(grid_step(bits) + division_error(primitive), scaling_error(primitive));
}

LoosePolygon loose_polygon(const ScenePrimitive& triangle, int bits) {
  LoosePolygon polygon{{}, reach_of(triangle, bits), triangle.viewport};
  for (const ClipPolygonVertex& vertex : seen_polygon(triangle, kParts))
    polygon.vertices.push_back(vertex.position);
  return polygon;
}

EndErrors end_errors(const ScenePrimitive& line) {
  return {error_of_vertex(line, 0), error_of_vertex(line, 1)};
}

LooseSegment snapped_segment(const ScenePrimitive& line, Snap snap, const EndErrors& errors) {
  LooseSegment result{{snap(line.positions[0]), snap(line.positions[1])}, {}};
  const Point* ends[] = {&result.segment.a, &result.segment.b};
  for (std::size_t i = 0; i < 2; ++i) {
    const Point nearest = nearest_point(line.positions[i]);
    const Fixed error = errors[i];
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
