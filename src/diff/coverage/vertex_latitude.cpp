// SPDX-License-Identifier: MIT
#include "diff/coverage/vertex_latitude.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "exact/fixed.h"
#include "exact/rational.h"
#include "model/clipped_line.h"
#include "rules/coverage/clip_volume.h"
#include "rules/coverage/triangle_algorithm.h"

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

// ------------------------------------------------------------------------------------------ facing

namespace {

struct Signs {
  bool may_be_positive = false;
  bool may_be_negative = false;
};

// The area is linear in each of the six components of the vertices' moves: over the open box of
// moves it takes a sign exactly if it has that sign at a corner of the box.
Signs signs_of_area(const Triangle& t, Fixed reach) {
  Signs signs;
  for (int corner = 0; corner < 64; ++corner) {
    const auto at = [&](Fixed coordinate, int bit) {
      return Int128{coordinate.raw()} + ((corner >> bit & 1) != 0 ? reach.raw() : -reach.raw());
    };
    const Int128 ax = at(t[0].x, 0);
    const Int128 ay = at(t[0].y, 1);
    const Int128 area =
        (at(t[1].x, 2) - ax) * (at(t[2].y, 5) - ay) - (at(t[1].y, 3) - ay) * (at(t[2].x, 4) - ax);
    signs.may_be_positive = signs.may_be_positive || area > 0;
    signs.may_be_negative = signs.may_be_negative || area < 0;
  }
  return signs;
}

// For a clipped triangle, by a bound: if each vertex moves by at most r in x and in y, twice the
// area changes by at most the sum of r (|dx| + |dy|) from each vertex' neighbour to its other one,
// and 2 r^2 for each pair of neighbours.
Signs signs_of_seen_area(const LoosePolygon& polygon) {
  const std::vector<Point>& p = polygon.vertices;
  if (p.size() < 3) return {true, true};
  const Int128 reach = polygon.reach.raw();
  Int128 area = 0;
  Int128 change = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point before = p[(i + p.size() - 1) % p.size()];
    const Point after = p[(i + 1) % p.size()];
    area += Int128{p[i].x.raw()} * after.y.raw() - Int128{after.x.raw()} * p[i].y.raw();
    change += reach * (std::abs(after.x.raw() - before.x.raw()) +
                       std::abs(after.y.raw() - before.y.raw())) +
              2 * reach * reach;
  }
  return {area + change > 0, area - change < 0};
}

// 14.6.1 also permits the area of the polygon before clipping. The quotients of a vertex behind the
// eye lie on its other side: with one or three such vertices, that area has the opposite sign. A
// vertex in the plane of the eye has no quotients, and so no sign.
bool may_turn_unclipped(const ScenePrimitive& triangle) {
  int behind = 0;
  for (const HomogeneousPoint& vertex : triangle.positions) {
    if (vertex.w == 0) return true;
    behind += vertex.w < 0 ? 1 : 0;
  }
  return behind % 2 == 1;
}

Signs signs_of(const ScenePrimitive& triangle, int bits) {
  if (triangle.is_clipped) {
    const Signs seen = signs_of_seen_area(loose_polygon(triangle, bits));
    if (!may_turn_unclipped(triangle)) return seen;
    return {true, true};
  }
  // Quotients are rounded to the nearest point; reach_of accounts for the error.
  return signs_of_area(nearest_triangle(triangle.positions), reach_of(triangle, bits));
}

}  // namespace

FacingLatitude permitted_facing(const ScenePrimitive& primitive, int bits) {
  if (primitive.kind != PrimitiveKind::triangle) return {};
  const Signs signs = signs_of(primitive, bits);
  if (primitive.state->front_face == FrontFace::ccw)
    return {signs.may_be_positive, signs.may_be_negative};
  return {signs.may_be_negative, signs.may_be_positive};
}

CullingLatitude permitted_culling(const ScenePrimitive& primitive, int bits) {
  const CullMode cull = primitive.state->cull;
  if (primitive.kind != PrimitiveKind::triangle || cull == CullMode::none) return {};
  const bool drops_front = cull == CullMode::front || cull == CullMode::front_and_back;
  const bool drops_back = cull == CullMode::back || cull == CullMode::front_and_back;
  const auto [front, back] = permitted_facing(primitive, bits);
  return {(front && drops_front) || (back && drops_back),
          (front && !drops_front) || (back && !drops_back)};
}

}  // namespace edgecase
