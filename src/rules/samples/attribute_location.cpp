// SPDX-License-Identifier: MIT
#include "rules/samples/attribute_location.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <span>

#include "rules/coverage/segment.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/samples/half_planes.h"
#include "rules/samples/sample_mask.h"

namespace edgecase {
namespace {

Point first_covered(const Invocation& invocation, const SamplePositions& positions) {
  return positions[static_cast<std::size_t>(std::countr_zero(invocation.coverage))];
}

Point mean_covered(const Invocation& invocation, const SamplePositions& positions) {
  const std::int64_t count = std::popcount(invocation.coverage);
  std::int64_t x = 0;
  std::int64_t y = 0;
  for (std::size_t s = 0; s < positions.size(); ++s) {
    if ((invocation.coverage >> s & 1) == 0) continue;
    x += positions[s].x.raw();
    y += positions[s].y.raw();
  }
  const auto nearest = [&](std::int64_t sum) {
    return Fixed::from_raw((2 * sum + count) / (2 * count));
  };
  return {nearest(x), nearest(y)};
}

Point half_pixel_off(PrimitiveKind kind, Point place) {
  if (kind == PrimitiveKind::triangle) return place;
  const Fixed half = Fixed::from_raw(Fixed::kOne / 2);
  return {place.x + half, place.y + half};
}

Point mirrored_x(Point place) {
  return {Fixed::from_integer(1) - place.x, place.y};
}

Point centroid_location(const Invocation& invocation, const SamplePositions& positions,
                        CentroidLocation choice) {
  const std::uint32_t all = mask_of_all(static_cast<int>(positions.size()));
  switch (choice) {
    case CentroidLocation::centre_or_first:
      return invocation.coverage == all ? centre_of_pixel() : first_covered(invocation, positions);
    case CentroidLocation::first_covered:
      return first_covered(invocation, positions);
    case CentroidLocation::mean_covered:
      return mean_covered(invocation, positions);
    case CentroidLocation::centre:
      return centre_of_pixel();
  }
  return centre_of_pixel();
}

}  // namespace

Point attribute_location(AttributeLocation qualifier, const Invocation& invocation,
                         const SamplePositions& positions, const LocationChoice& choice) {
  Point place = centre_of_pixel();
  if (invocation.per_sample)
    place = first_covered(invocation, positions);
  else if (qualifier == AttributeLocation::centroid)
    place = centroid_location(invocation, positions, choice.centroid);
  else if (choice.plain == PlainLocation::first_covered)
    place = first_covered(invocation, positions);
  const bool is_off = choice.plain == PlainLocation::half_pixel_off;
  return is_off ? half_pixel_off(invocation.kind, place) : place;
}

Point coordinates_location(const Invocation& invocation, const SamplePositions& positions) {
  return invocation.per_sample ? first_covered(invocation, positions) : centre_of_pixel();
}

Point fragment_depth_location(const Invocation& invocation, const SamplePositions& positions,
                              const LocationChoice& choice) {
  const Point place = coordinates_location(invocation, positions);
  switch (choice.depth) {
    case DepthLocation::at_sample:
      return place;
    case DepthLocation::centre:
      return centre_of_pixel();
    case DepthLocation::mirrored_x:
    case DepthLocation::mirrored_x_or_zero:
      return mirrored_x(positions[0]);
    case DepthLocation::half_pixel_off:
      return half_pixel_off(invocation.kind, place);
  }
  return place;
}

bool fragment_depth_is_zero(const Multisampling& use, const LocationChoice& choice) {
  return choice.depth == DepthLocation::mirrored_x_or_zero && use.enabled && (use.mask & 1) == 0;
}

Point sample_depth_location(PrimitiveKind kind, Point sample, const LocationChoice& choice) {
  switch (choice.depth) {
    case DepthLocation::at_sample:
      return sample;
    case DepthLocation::centre:
      return centre_of_pixel();
    case DepthLocation::mirrored_x:
    case DepthLocation::mirrored_x_or_zero:
      return mirrored_x(sample);
    case DepthLocation::half_pixel_off:
      return half_pixel_off(kind, sample);
  }
  return sample;
}

bool is_at_sample(const Multisampling& use) {
  return use.location == AttributeLocation::sample || use.min_sample_shading == 1.0F;
}

Rule attribute_location_rule() {
  return {
      RuleId::attribute_location,
      "Attributes of a multisampled fragment are evaluated in its pixel",
      "14.3.1 (multisampling) and 14.3.1.1 (sample shading)",
      "anywhere in the pixel, unless the shader qualifies the attribute or runs for each sample",
      "centre",
      alternatives_of<PlainLocation>(),
      {{29,
        "Multisampled targets: an attribute without a qualifier may be evaluated anywhere in the "
        "fragment's pixel, boundary included, each one at a place of its own, and so may "
        "gl_FragCoord, which no qualifier concerns. Qualified sample, or under GL_SAMPLE_SHADING "
        "with a share of 1, attributes are evaluated at the sample that the invocation runs for, "
        "and with that share so is gl_FragCoord (ruling 63). The depth that is written to a sample "
        "is always "
        "evaluated there. With GL_MULTISAMPLE disabled attributes and gl_FragCoord are those of "
        "the centre or, whatever their qualifiers, of any place in the pixel; of depths see ruling "
        "35."}}};
}

Rule centroid_rule() {
  return {RuleId::attribute_centroid,
          "A centroid attribute is evaluated where its primitive covers the pixel",
          "14.3.1 (multisampling); GLSL 4.60, 4.5 (interpolation qualifiers)",
          "any place that lies both in the pixel and in the primitive",
          "centre-or-first",
          alternatives_of<CentroidLocation>(),
          {{30,
            "Attributes qualified centroid may be evaluated anywhere in what the pixel and the "
            "primitive (of a point its square, of a line its rectangle) have in common, boundaries "
            "included, for some position of each vertex less than one step of 2^-b away (b as in "
            "ruling "
            "4)."}}};
}

Rule sample_depth_rule() {
  return {RuleId::sample_depth,
          "Each sample has the depth at its own location",
          "14.3.1 (multisampling)",
          "none beyond that of values (ruling 29)",
          "at-sample",
          alternatives_of<DepthLocation>(),
          {}};
}

// permitted_locations: the part of a pixel that a primitive covers, for all moves of its vertices.

namespace {

using HalfPlanes = std::vector<HalfPlane>;

std::int64_t raw_length(Fixed from, Fixed to) {
  return std::abs(to.raw() - from.raw());
}

// A box round points, grown by a margin on each side.
void add_box(HalfPlanes& planes, std::span<const Point> points, std::int64_t margin) {
  const auto [left, right] =
      std::minmax_element(points.begin(), points.end(), [](Point a, Point b) { return a.x < b.x; });
  const auto [bottom, top] =
      std::minmax_element(points.begin(), points.end(), [](Point a, Point b) { return a.y < b.y; });
  planes.push_back({-1, 0, margin - left->x.raw()});
  planes.push_back({1, 0, right->x.raw() + margin});
  planes.push_back({0, -1, margin - bottom->y.raw()});
  planes.push_back({0, 1, top->y.raw() + margin});
}

// All moved triangles lie in the sum of the triangle and a square (triangle_fill.cpp).
void add_triangle(HalfPlanes& planes, const Triangle& given, std::int64_t reach) {
  add_box(planes, given, reach);
  if (doubled_area(given) == 0) return;
  const Triangle t = counter_clockwise(given);
  for (std::size_t i = 0; i < 3; ++i) {
    const Point a = t[i];
    const Point b = t[(i + 1) % 3];
    const std::int64_t dx = b.x.raw() - a.x.raw();
    const std::int64_t dy = b.y.raw() - a.y.raw();
    const Int128 at_a = Int128{dy} * a.x.raw() - Int128{dx} * a.y.raw();
    planes.push_back({dy, -dx, at_a + Int128{std::abs(dx) + std::abs(dy)} * reach});
  }
}

// The whole number at or above the square root; the number is at most 2^62.
std::int64_t root_above(Int128 value) {
  assert(0 <= value && value <= Int128{1} << 62);
  auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(value)));
  while (Int128{root} * root < value) ++root;
  return root;
}

// How much a product of the segment and the way from an end to a point of the pixel can change as
// the ends move: the end itself moves, and the segment changes by twice as much.
Int128 change_of_products(const Segment& s, Point end, PixelPosition pixel, std::int64_t reach) {
  const auto farthest = [&](Fixed from, int column) {
    return std::max(raw_length(from, Fixed::from_integer(column)),
                    raw_length(from, Fixed::from_integer(column + 1)));
  };
  const std::int64_t way = farthest(end.x, pixel.x) + farthest(end.y, pixel.y) + 2 * reach;
  const std::int64_t run = raw_length(s.a.x, s.b.x) + raw_length(s.a.y, s.b.y);
  return Int128{way} * 2 * reach + Int128{run} * reach;
}

void add_rectangle(HalfPlanes& planes, const Segment& s, Fixed width, PixelPosition pixel,
                   std::int64_t reach) {
  const std::int64_t dx = s.b.x.raw() - s.a.x.raw();
  const std::int64_t dy = s.b.y.raw() - s.a.y.raw();
  const auto along = [&](Point p) { return Int128{dx} * p.x.raw() + Int128{dy} * p.y.raw(); };
  planes.push_back({-dx, -dy, change_of_products(s, s.a, pixel, reach) - along(s.a)});
  planes.push_back({dx, dy, along(s.b) + change_of_products(s, s.b, pixel, reach)});
  // Half the width times the length, for a segment whose ends move apart or together.
  const std::int64_t length = root_above(Int128{dx} * dx + Int128{dy} * dy) + 3 * reach;
  const Int128 aside =
      (Int128{width.raw()} * length + 1) / 2 + change_of_products(s, s.a, pixel, reach);
  const Int128 at_a = Int128{dy} * s.a.x.raw() - Int128{dx} * s.a.y.raw();
  planes.push_back({dy, -dx, aside + at_a});
  planes.push_back({-dy, dx, aside - at_a});
}

std::vector<Point> corners_of_pixel(PixelPosition pixel) {
  return corners_of(half_planes_of(pixel));
}

std::vector<Point> shared_corners(const ScenePrimitive& primitive, PixelPosition pixel,
                                  Fixed reach) {
  // The position of a quotient is known to the nearest multiple of 2^-16.
  const std::int64_t margin = reach.raw() + (has_clip_positions(primitive) ? 1 : 0);
  std::array<Point, 3> p;
  std::transform(primitive.positions.begin(), primitive.positions.end(), p.begin(), nearest_point);
  const auto square = half_planes_of(pixel);
  HalfPlanes planes(square.begin(), square.end());
  switch (primitive.kind) {
    case PrimitiveKind::point:
      add_box(planes, {p.data(), 1}, (primitive.state->point_size.raw() + 1) / 2 + margin);
      break;
    case PrimitiveKind::line:
      add_rectangle(planes, {p[0], p[1]}, primitive.state->line_width, pixel, margin);
      break;
    case PrimitiveKind::triangle:
      add_triangle(planes, p, margin);
      break;
  }
  std::vector<Point> corners = corners_of(planes);
  return corners.empty() ? corners_of_pixel(pixel) : corners;
}

}  // namespace

std::vector<Point> permitted_locations(const ScenePrimitive& primitive, PixelPosition pixel,
                                       Point sample, Fixed reach) {
  const Multisampling& use = primitive.state->multisampling;
  if (!use.enabled) return corners_of_pixel(pixel);
  if (is_at_sample(use)) return {place_in(pixel, sample)};
  if (use.location == AttributeLocation::centroid) return shared_corners(primitive, pixel, reach);
  return corners_of_pixel(pixel);
}

std::vector<Point> permitted_coordinate_locations(const Multisampling& use, PixelPosition pixel,
                                                  Point sample) {
  if (use.enabled && use.min_sample_shading == 1.0F) return {place_in(pixel, sample)};
  return corners_of_pixel(pixel);
}

}  // namespace edgecase
