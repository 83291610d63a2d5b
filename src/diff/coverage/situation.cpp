// SPDX-License-Identifier: MIT
#include "diff/coverage/situation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <span>
#include <vector>

#include "exact/fixed.h"
#include "rules/coverage/clip_polygon.h"
#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/homogeneous_triangle.h"
#include "rules/coverage/line_algorithm.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {
namespace {

// Distances that are distinguished, raw, with their names; anything farther is "farther".
struct Reach {
  std::int64_t raw;
  const char* name;
};
constexpr std::array<Reach, 3> kReaches = {{{Fixed::kOne >> 8, "within 1/256 pixel"},
                                            {Fixed::kOne >> 4, "within 1/16 pixel"},
                                            {Fixed::kOne, "within 1 pixel"}}};

template <class IsWithin>
const char* name_of_reach(IsWithin is_within) {
  for (const Reach& reach : kReaches)
    if (is_within(reach.raw)) return reach.name;
  return "more than 1 pixel";
}

// The position of a point in the diamond of the pixel that contains it or whose corner it is.
std::string place_in_diamond(Point p, PixelPosition pixel) {
  const Point centre = pixel_centre(pixel.x, pixel.y);
  const std::int64_t dx = p.x.raw() - centre.x.raw();
  const std::int64_t dy = p.y.raw() - centre.y.raw();
  const std::int64_t distance = std::abs(dx) + std::abs(dy);
  if (distance == 0) return "at the centre of its diamond";
  if (2 * distance < Fixed::kOne) return "inside its diamond";
  if (2 * distance > Fixed::kOne) return "outside its diamond";
  if (dy == 0) return fmt::format("on the {} corner of its diamond", dx < 0 ? "left" : "right");
  if (dx == 0) return fmt::format("on the {} corner of its diamond", dy < 0 ? "lower" : "upper");
  return fmt::format("on the {} {} edge of its diamond", dy < 0 ? "lower" : "upper",
                     dx < 0 ? "left" : "right");
}

// "horizontal right", "x-major right and up", "diagonal left and down", "vertical down", …
std::string direction_of(const Segment& s) {
  const std::int64_t dx = s.b.x.raw() - s.a.x.raw();
  const std::int64_t dy = s.b.y.raw() - s.a.y.raw();
  const char* right = dx > 0 ? "right" : "left";
  const char* up = dy > 0 ? "up" : "down";
  if (dx == 0 && dy == 0) return "without length";
  if (dy == 0) return fmt::format("horizontal {}", right);
  if (dx == 0) return fmt::format("vertical {}", up);
  if (std::abs(dx) == std::abs(dy)) return fmt::format("diagonal {} and {}", right, up);
  return fmt::format("{}-major {} and {}", s.x_major() ? "x" : "y", right, up);
}

bool pixel_has(PixelPosition pixel, Point p) {
  return p.x.floor() == pixel.x && p.y.floor() == pixel.y;
}

// A pixel whose closed diamond contains the point, or the pixel that contains it.
bool is_at(PixelPosition pixel, Point p) {
  const Point centre = pixel_centre(pixel.x, pixel.y);
  return pixel_has(pixel, p) ||
         2 * (std::abs(p.x.raw() - centre.x.raw()) + std::abs(p.y.raw() - centre.y.raw())) <=
             Fixed::kOne;
}

// Beyond an end of the segment, or beside it.
std::string place_away_from_ends(const Segment& s, PixelPosition pixel) {
  const bool x_major = s.x_major();
  const auto major = [&](Point p) { return x_major ? p.x.raw() : p.y.raw(); };
  const std::int64_t sign = major(s.b) < major(s.a) ? -1 : 1;
  const std::int64_t at = sign * major(pixel_centre(pixel.x, pixel.y));
  if (at < sign * major(s.a)) return "before the start";
  if (at > sign * major(s.b)) return "beyond the end";
  if (meets_diamond(s, pixel.x, pixel.y, *find_diamond_boundary("open"))) return "along the way";
  if (meets_diamond(s, pixel.x, pixel.y, *find_diamond_boundary("closed")))
    return "along the way, where it only touches the diamond";
  return "beside the line";
}

std::string line_situation(const ScenePrimitive& line, PixelPosition pixel) {
  const Segment s{nearest_point(line.positions[0]), nearest_point(line.positions[1])};
  const int width = rounded_width(line.state->line_width);
  std::string place;
  if (is_at(pixel, s.a)) place = "first pixel, start " + place_in_diamond(s.a, pixel);
  if (is_at(pixel, s.b))
    place += fmt::format("{}last pixel, end {}", place.empty() ? "" : "; ",
                         place_in_diamond(s.b, pixel));
  if (place.empty()) place = place_away_from_ends(s, pixel);
  return fmt::format("{}, {}, {}", width == 1 ? "line" : "wide line", direction_of(s), place);
}

// True if the sample lies within a distance of the edge's line (raw), or on its inner side.
bool is_beyond(Point a, Point b, Point sample, std::int64_t distance) {
  const std::int64_t side = cross(a, b, sample);
  if (side >= 0) return true;
  const Int128 dx = b.x.raw() - a.x.raw();
  const Int128 dy = b.y.raw() - a.y.raw();
  return static_cast<Int128>(side) * side <= (dx * dx + dy * dy) * distance * distance;
}

// The position of a sample relative to a convex polygon with counter-clockwise vertices.
std::string polygon_situation(const char* name, std::span<const Point> t, Point sample) {
  if (std::find(t.begin(), t.end(), sample) != t.end())
    return fmt::format("{}, sample at a vertex", name);
  const auto every_edge = [&](auto condition) {
    for (std::size_t i = 0; i < t.size(); ++i)
      if (!condition(t[i], t[(i + 1) % t.size()])) return false;
    return true;
  };
  const bool outside = !every_edge([&](Point a, Point b) { return cross(a, b, sample) >= 0; });
  if (!outside)
    for (std::size_t i = 0; i < t.size(); ++i)
      if (cross(t[i], t[(i + 1) % t.size()], sample) == 0)
        return fmt::format("{}, sample exactly on a {} edge", name,
                           edge_kind(t[i], t[(i + 1) % t.size()]));
  // Inside, the reversed edge gives the distance to its line on the other side.
  const char* reach = name_of_reach([&](std::int64_t distance) {
    return outside
               ? every_edge([&](Point a, Point b) { return is_beyond(a, b, sample, distance); })
               : !every_edge([&](Point a, Point b) { return !is_beyond(b, a, sample, distance); });
  });
  return fmt::format("{}, sample {} {}", name, outside ? "outside," : "inside,", reach);
}

std::string triangle_situation(const ScenePrimitive& triangle, Point sample) {
  const Triangle given = nearest_triangle(triangle.positions);
  if (doubled_area(given) == 0) return "triangle without area";
  return polygon_situation("triangle", counter_clockwise(given), sample);
}

std::string clipped_situation(const ScenePrimitive& primitive, Point sample) {
  if (primitive.kind != PrimitiveKind::triangle) return "point outside the clip volume";
  std::vector<Point> polygon;
  for (const ClipPolygonVertex& vertex : seen_polygon(primitive))
    if (polygon.empty() || polygon.back() != vertex.position) polygon.push_back(vertex.position);
  if (polygon.size() < 3) return "clipped triangle of which nothing is seen";
  if (cross(primitive.positions[0], primitive.positions[1], primitive.positions[2]) < 0)
    std::reverse(polygon.begin(), polygon.end());
  return polygon_situation("clipped triangle", polygon, sample);
}

std::string point_situation(const ScenePrimitive& point, Point sample, bool multisampled) {
  const Point vertex = nearest_point(point.positions[0]);
  const Fixed size = point.state->point_size;
  // All distances are doubled, since half a size need not be a whole raw unit.
  const std::int64_t dx = 2 * (sample.x.raw() - vertex.x.raw());
  const std::int64_t dy = 2 * (sample.y.raw() - vertex.y.raw());
  const std::int64_t beyond = std::max(std::abs(dx), std::abs(dy)) - size.raw();
  const char* kind = size == Fixed::from_integer(1) ? "point of size 1" : "sized point";
  const char* what = multisampled ? "sample" : "centre";
  if (beyond == 0) {
    const bool corner = std::abs(dx) == std::abs(dy);
    const char* side =
        std::abs(dx) > std::abs(dy) ? (dx < 0 ? "left" : "right") : (dy < 0 ? "bottom" : "top");
    return corner ? fmt::format("{}, {} exactly on a corner", kind, what)
                  : fmt::format("{}, {} exactly on the {} side", kind, what, side);
  }
  const char* reach =
      name_of_reach([&](std::int64_t distance) { return std::abs(beyond) <= 2 * distance; });
  return fmt::format("{}, {} {} {}", kind, what, beyond > 0 ? "outside," : "inside,", reach);
}

// The position of a sample relative to the rectangle of a multisampled line.
std::string rectangle_situation(const ScenePrimitive& line, Point sample) {
  const Segment s{nearest_point(line.positions[0]), nearest_point(line.positions[1])};
  const Int128 dx = s.b.x.raw() - s.a.x.raw();
  const Int128 dy = s.b.y.raw() - s.a.y.raw();
  const Int128 along = dx * (sample.x.raw() - s.a.x.raw()) + dy * (sample.y.raw() - s.a.y.raw());
  const Int128 length = dx * dx + dy * dy;
  // Both squares are multiplied by four times the squared length: of the distance from the line,
  // and of half the width.
  const Int128 side = cross(s.a, s.b, sample);
  const Int128 width = line.state->line_width.raw();
  const Int128 beyond = 4 * side * side - length * width * width;
  const char* place = along < 0                       ? "before the start"
                      : along > length                ? "beyond the end"
                      : beyond > 0                    ? "beside the rectangle"
                      : beyond == 0                   ? "exactly on a side"
                      : along == 0 || along == length ? "exactly on an end"
                                                      : "inside the rectangle";
  return fmt::format("multisampled line, {}, sample {}", direction_of(s), place);
}

std::string situation_by_kind(const ScenePrimitive& primitive, Point sample, const Target& target) {
  const bool multisampled = is_multisampled(*primitive.state, target);
  if (primitive.is_clipped) return clipped_situation(primitive, sample);
  switch (primitive.kind) {
    case PrimitiveKind::point:
      return point_situation(primitive, sample, multisampled);
    case PrimitiveKind::line:
      if (multisampled) return rectangle_situation(primitive, sample);
      return line_situation(
          primitive, {static_cast<int>(sample.x.floor()), static_cast<int>(sample.y.floor())});
    case PrimitiveKind::triangle:
      return triangle_situation(primitive, sample);
  }
  return "";
}

}  // namespace

std::string situation_of(const ScenePrimitive& primitive, Point sample, const Target& target) {
  const char* divided = has_clip_positions(primitive) ? ", to the nearest 1/65536 pixel" : "";
  return situation_by_kind(primitive, sample, target) + divided;
}

}  // namespace edgecase
