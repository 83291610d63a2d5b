// SPDX-License-Identifier: MIT

#include "tests/adversaries/shape.h"

#include <algorithm>
#include <cmath>

#include "exact/fixed.h"

namespace edgecase::adversary {
namespace {

using Wide = Int128;

Wide side(Place a, Place b, Place p) {
  return Wide{b.x - a.x} * (p.y - a.y) - Wide{b.y - a.y} * (p.x - a.x);
}

bool is_outside(const Corner& corner) {
  const auto& [x, y, z, w] = corner.clip;
  return !(w > 0 && std::abs(x) <= w && std::abs(y) <= w && std::abs(z) <= w);
}

// 13.7.1: the point at a part of the way, from the end that stays to the one that goes.
Corner between(const Corner& a, const Corner& b, double part, bool smooth) {
  Corner made;
  for (std::size_t i = 0; i < 4; ++i) made.clip[i] = a.clip[i] + (b.clip[i] - a.clip[i]) * part;
  const double of_value = smooth ? part : part * b.clip[3] / made.clip[3];
  for (std::size_t i = 0; i < 4; ++i)
    made.value[i] = a.value[i] + (b.value[i] - a.value[i]) * of_value;
  return made;
}

}  // namespace

std::int64_t Shaper::snapped(double pixels, std::uint64_t luck, bool is_line) const {
  const double step = std::ldexp(1.0, 16 - freedoms_.bits), steps = pixels * kPixel / step;
  const double down = std::floor(steps);
  double to = down;
  // Ruling 1 asks of lines that all ends are moved in one way.
  if (freedoms_.snap == Snap::nearest || (freedoms_.snap == Snap::either && is_line))
    to = std::floor(steps + 0.5);
  if (freedoms_.snap == Snap::up) to = std::ceil(steps);
  if (freedoms_.snap == Snap::either && !is_line && (luck & 1) != 0) to = std::ceil(steps);
  if (freedoms_.crime == "a step too far") to = down - 1;
  return static_cast<std::int64_t>(to * step);
}

// `given`: the vertex that the corner is, or none of one that clipping made.
void Shaper::place(Corner& corner, const Vertex* given, bool is_line) const {
  const auto& [x, y, z, w] = corner.clip;
  const Viewport& v = scene_.viewport;
  const double near = static_cast<double>(scene_.depth_range.near);
  const double far = static_cast<double>(scene_.depth_range.far);
  seed_errors(hash(hash(hash_of(x), hash_of(y)), hash(hash_of(z), hash_of(w))));
  const bool as_given =
      given != nullptr && !given->clip && (given->w == 1 && !freedoms_.computes_windows);
  if (as_given) {
    corner.x = given->position.x.to_double();
    corner.y = given->position.y.to_double();
    const double depth = given->z.to_double();
    corner.depth = near == 0 && far == 1 ? Real((depth + 1) / 2)
                                         : Real((far - near) / 2) * depth + Real((near + far) / 2);
  } else {
    corner.x = Real(v.width / 2.0) * (Real(x) / w) + (v.x + v.width / 2.0);
    corner.y = Real(v.height / 2.0) * (Real(y) / w) + (v.y + v.height / 2.0);
    corner.depth = Real((far - near) / 2) * (Real(z) / w) + Real((near + far) / 2);
  }
  // 14.2: a primitive that is moved by whole pixels has the same luck, whatever the errors of its
  // computation, up to 2^-9 pixel.
  const auto part_of = [](double n) {
    constexpr std::int64_t kParts = 256;
    return static_cast<std::uint64_t>(std::llround((n - std::floor(n)) * kParts) % kParts);
  };
  const std::uint64_t luck = hash(part_of(corner.x.value), part_of(corner.y.value));
  corner.place = {snapped(corner.x.value, luck, is_line),
                  snapped(corner.y.value, luck >> 1, is_line)};
  if (!freedoms_.values_from_snapped) return;
  corner.x = static_cast<double>(corner.place.x) / kPixel;
  corner.y = static_cast<double>(corner.place.y) / kPixel;
}

Corner Shaper::corner_of(const Vertex& vertex, const Draw& draw) const {
  Corner corner;
  const Viewport& v = scene_.viewport;
  if (vertex.clip) {
    corner.clip = {vertex.clip->x, vertex.clip->y, vertex.clip->z, vertex.clip->w};
  } else {
    const double w = static_cast<double>(vertex.w);
    corner.clip = {(2 * (vertex.position.x.to_double() - v.x) / v.width - 1) * w,
                   (2 * (vertex.position.y.to_double() - v.y) / v.height - 1) * w,
                   vertex.z.to_double() * w, w};
  }
  const Color value = interpolated_attribute(draw, vertex);
  std::copy(value.begin(), value.end(), corner.value.begin());
  return corner;
}

// 13.7: Sutherland and Hodgman, at near and far, at the sides of the guard band, and before the
// eye.
std::vector<Corner> Shaper::cut(std::vector<Corner> polygon, bool smooth) const {
  const bool open = polygon.size() == 2;
  const double g = open ? 1 : freedoms_.guard_band;
  const double planes[][4] = {{0, 0, 1, 1},  {0, 0, -1, 1}, {0, 0, 0, 1}, {1, 0, 0, g},
                              {-1, 0, 0, g}, {0, 1, 0, g},  {0, -1, 0, g}};
  for (const auto& plane : planes) {
    const auto inside = [&](const Corner& c) {
      const double least =
          plane[2] == 0 && plane[3] == 1 && plane[0] == 0 && plane[1] == 0 ? 1e-9 : 0;
      return plane[0] * c.clip[0] + plane[1] * c.clip[1] + plane[2] * c.clip[2] +
             plane[3] * c.clip[3] - least;
    };
    std::vector<Corner> left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const double at_a = inside(a), at_b = inside(b);
      if (at_a >= 0) left.push_back(a);
      if ((at_a >= 0) == (at_b >= 0) || (open && i == 1)) continue;
      left.push_back(at_a >= 0 ? between(a, b, at_a / (at_a - at_b), smooth)
                               : between(b, a, at_b / (at_b - at_a), smooth));
    }
    polygon = std::move(left);
  }
  return polygon;
}

Shape Shaper::shape_of(const ScenePrimitive& primitive) const {
  Shape shape;
  shape.primitive = &primitive;
  shape.draw = primitive.state;
  const Draw& draw = *primitive.state;
  std::vector<Corner> corners;
  for (int i = 0; i < vertices_of(primitive.kind); ++i)
    corners.push_back(corner_of(*primitive.vertices[static_cast<std::size_t>(i)], draw));
  const bool first = draw.provoking_vertex == ProvokingVertex::first;
  shape.provoking = corners[static_cast<std::size_t>(first ? primitive.provoking_first
                                                           : primitive.provoking_last)]
                        .value;
  shape.bounds = {0, 0, scene_.target.width - 1, scene_.target.height - 1};
  if (draw.scissor) shape.bounds = common_part(shape.bounds, pixels_in(*draw.scissor));
  const bool is_line = primitive.kind == PrimitiveKind::line;
  const bool is_area = primitive.kind == PrimitiveKind::triangle;
  if (is_area || freedoms_.cut_at_viewport)
    shape.bounds = common_part(shape.bounds, pixels_in(scene_.viewport));

  if (primitive.kind == PrimitiveKind::point) {
    const auto& [x, y, z, w] = corners[0].clip;
    if (!(w > 0 && std::abs(z) <= w)) return shape;
    if (is_outside(corners[0]) && !freedoms_.draws_points_outside) return shape;
    if (freedoms_.crime == "points on the side dropped" && std::abs(x) >= 0.9 * w) return shape;
  } else if (std::any_of(corners.begin(), corners.end(), is_outside)) {
    shape.is_cut = true;
    const std::size_t given = corners.size();
    std::vector<Corner> left = cut(corners, draw.interpolation != Interpolation::noperspective);
    if (left.size() < given) return shape;
    for (Corner& corner : left) {
      const Vertex* vertex = nullptr;
      for (std::size_t i = 0; i < given; ++i)
        if (corner.clip == corners[i].clip) vertex = primitive.vertices[i];
      place(corner, vertex, is_line);
    }
    finish_polygon(shape, left);
    return shape;
  }
  for (std::size_t i = 0; i < corners.size(); ++i)
    place(corners[i], primitive.vertices[i], is_line);
  finish_polygon(shape, corners);
  return shape;
}

void Shaper::finish_polygon(Shape& shape, const std::vector<Corner>& polygon) const {
  if (polygon.size() < 3) {
    Piece piece;
    std::copy(polygon.begin(), polygon.end(), piece.corners.begin());
    shape.pieces = {piece};
    return;
  }
  Wide area = 0;
  const std::size_t n = polygon.size(), pivot = freedoms_.fan_pivot == 0 ? 0 : n - 1;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Piece piece{{polygon[pivot], polygon[(pivot + i) % n], polygon[(pivot + i + 1) % n]}};
    area += side(piece.corners[0].place, piece.corners[1].place, piece.corners[2].place);
    shape.pieces.push_back(piece);
  }
  // 14.6.1: from the (clipped or unclipped) area; a polygon of none faces the back.
  const Draw& draw = *shape.draw;
  shape.front = draw.front_face == FrontFace::ccw ? area > 0 : area < 0;
  const bool culled = draw.cull == CullMode::front_and_back ||
                      draw.cull == (shape.front ? CullMode::front : CullMode::back);
  if (culled || area == 0) shape.pieces.clear();
}

// Does a place belong to what lies beyond, where this grows along x and y so?
bool Shaper::owns(std::int64_t along_x, std::int64_t along_y) const {
  const std::int64_t by_x = along_x * freedoms_.tie_x, by_y = along_y * freedoms_.tie_y;
  const std::int64_t first = freedoms_.tie_y_first ? by_y : by_x;
  return first != 0 ? first > 0 : (freedoms_.tie_y_first ? by_x : by_y) > 0;
}

bool Shaper::covers(const Piece& triangle, Place place, int index) const {
  const auto& c = triangle.corners;
  const Wide area = side(c[0].place, c[1].place, c[2].place);
  if (area == 0) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    Place a = c[i].place, b = c[(i + 1) % 3].place;
    if (area < 0) std::swap(a, b);
    const Wide inside = side(a, b, place);
    if (inside < 0) return false;
    if (inside > 0) continue;
    bool owned = owns(a.y - b.y, b.x - a.x);
    if (freedoms_.tie_by_edge) {
      const auto& [low, high] = std::minmax(a, b);
      // Where it lies in its pixel, and how far the other end is: 14.2.
      const auto of_low = hash(static_cast<std::uint64_t>(low.x) % kPixel,
                               static_cast<std::uint64_t>(low.y) % kPixel);
      const auto luck = hash(of_low, hash(static_cast<std::uint64_t>(high.x - low.x),
                                          static_cast<std::uint64_t>(high.y - low.y)));
      owned = (a < b) == ((luck & 1) != 0);
    }
    if (freedoms_.crime == "a tie rule for each triangle" && index % 2 != 0) owned = !owned;
    if (!owned) return false;
  }
  return true;
}

// 14.4.1 and 14.4.3: a square round the vertex. Who owns its sides is open.
bool Shaper::point_covers(const Shape& shape, Place place) const {
  const Place at = shape.pieces[0].corners[0].place;
  const std::int64_t size =
      shape.draw->point_size.raw() +
      (freedoms_.crime == "points a step larger" ? 2 * (kPixel >> freedoms_.bits) + 2 : 0);
  const bool closed =
      (hash(static_cast<std::uint64_t>(at.x) % kPixel, static_cast<std::uint64_t>(at.y) % kPixel) &
       1) != 0;
  for (const auto& [off, tie] : {std::array{place.x - at.x, std::int64_t{freedoms_.tie_x}},
                                 std::array{place.y - at.y, std::int64_t{freedoms_.tie_y}}}) {
    const std::int64_t beyond = 2 * std::abs(off) - size;
    const bool owned = freedoms_.tie_by_point ? closed : (off > 0) == (tie < 0);
    if (beyond > 0 || (beyond == 0 && !owned)) return false;
  }
  return true;
}

// 14.5.4: a rectangle as long as the segment and as wide as the line.
bool Shaper::rectangle_covers(const Shape& shape, Place place) const {
  const Place a = shape.pieces[0].corners[0].place, b = shape.pieces[0].corners[1].place;
  const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
  const Wide squared = Wide{dx} * dx + Wide{dy} * dy;
  if (squared == 0) return false;
  const Wide ahead = Wide{place.x - a.x} * dx + Wide{place.y - a.y} * dy;
  const Wide aside = Wide{dx} * (place.y - a.y) - Wide{dy} * (place.x - a.x);
  if (ahead < 0 || ahead > squared) return false;
  if (ahead == 0 && !owns(dx, dy)) return false;
  if (ahead == squared && !owns(-dx, -dy)) return false;
  // 4 aside^2 against (width length)^2: beyond 128 bits for long lines, so long double decides what
  // is not near.
  const long double width = static_cast<long double>(shape.draw->line_width.raw());
  const long double reach = width * std::sqrt(static_cast<long double>(squared));
  const long double twice = 2 * std::abs(static_cast<long double>(aside));
  if (std::abs(twice - reach) > reach * 1e-15L) return twice < reach;
  const int left = aside > 0 ? 1 : -1;
  return owns(left * dy, -left * dx);
}

const Piece* Shaper::piece_at(const Shape& shape, Place place) const {
  if (shape.pieces.empty()) return nullptr;
  if (shape.primitive->kind == PrimitiveKind::point)
    return point_covers(shape, place) ? &shape.pieces[0] : nullptr;
  if (shape.primitive->kind == PrimitiveKind::line)
    return rectangle_covers(shape, place) ? &shape.pieces[0] : nullptr;
  for (const Piece& piece : shape.pieces)
    if (covers(piece, place, shape.primitive->index)) return &piece;
  return nullptr;
}

}  // namespace edgecase::adversary
