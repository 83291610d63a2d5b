// SPDX-License-Identifier: MIT
#include "raster/coverage_stages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "kernels/edge_functions.h"
#include "kernels/kernels.h"
#include "raster/attributes.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "rules/coverage/clip_polygon.h"
#include "rules/coverage/clip_volume.h"
#include "rules/coverage/homogeneous_triangle.h"
#include "rules/coverage/triangle_algorithm.h"

namespace edgecase {
namespace {

using Corners = std::array<HomogeneousPoint, 3>;

Corners snapped_corners(const ScenePrimitive& triangle, const Target& target,
                        const CoverageChoice& choice) {
  Corners corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = snapped_position(triangle, i, choice, target);
  return corners;
}

// The area in square pixels, as text for people. A triangle behind the eye has none.
std::string area_of(const ScenePrimitive& triangle, const Corners& p) {
  if (triangle.is_clipped) return "seen from the eye";
  const double scale =
      static_cast<double>(p[0].w) * static_cast<double>(p[1].w) * static_cast<double>(p[2].w);
  return fmt::format("area {:.6g} square pixels",
                     static_cast<double>(cross(p[0], p[1], p[2])) / scale / 2);
}

std::string way_round(const Corners& corners) {
  const Int128 area = cross(corners[0], corners[1], corners[2]);
  if (area == 0) return "neither way round";
  return area > 0 ? "counter-clockwise" : "clockwise";
}

std::string note_on(FacingMethod method) {
  if (method == FacingMethod::as_set) return "";
  const char* name = name_of(method);
  return fmt::format("; as {} has it: {}", name,
                     find_alternative(rule_of(RuleId::polygon_facing), name)->meaning);
}

}  // namespace

bool is_front_facing(const ScenePrimitive& primitive, const Target& target,
                     const CoverageChoice& choice) {
  if (primitive.kind != PrimitiveKind::triangle) return true;
  return is_front_facing(primitive, snapped_corners(primitive, target, choice), choice.facing);
}

bool is_culled(const ScenePrimitive& primitive, const Target& target,
               const CoverageChoice& choice) {
  if (primitive.kind != PrimitiveKind::triangle || primitive.state->cull == CullMode::none)
    return false;
  return is_culled(primitive, snapped_corners(primitive, target, choice), choice.facing);
}

std::optional<Explanation> explain_culling(const ScenePrimitive& primitive, const Target& target,
                                           const CoverageChoice& choice) {
  if (!is_culled(primitive, target, choice)) return std::nullopt;
  const Corners corners = snapped_corners(primitive, target, choice);
  std::vector<Point> points;
  if (primitive.is_clipped)
    for (const ClipPolygonVertex& vertex : seen_polygon(primitive))
      points.push_back(vertex.position);
  else
    for (const HomogeneousPoint& corner : corners) points.push_back(nearest_point(corner));
  std::string places;
  for (const Point point : points)
    places += fmt::format("{}{}", places.empty() ? " " : ", ", format_point(point));
  const Draw& draw = *primitive.state;
  Explanation why;
  why.text = fmt::format(
      "the triangle{} is culled and makes no fragments: its vertices run {} in the window ({}), "
      "front faces are {}, so that it faces the {}, and cull is {}{}",
      places, way_round(corners), area_of(primitive, corners), name_of(draw.front_face),
      is_front_facing(primitive, corners, choice.facing) ? "front" : "back", name_of(draw.cull),
      note_on(choice.facing));
  why.figure.marks = {{MarkRole::edge, true, {}, ""}};
  for (Point point : points) why.figure.marks[0].points.push_back(position_of(point));
  return why;
}

namespace {

// Why there is no block walk of the primitive; empty if there is one.
std::string absence_of(const ScenePrimitive& primitive, const Target& target,
                       const CoverageChoice& choice) {
  if (primitive.kind != PrimitiveKind::triangle)
    return fmt::format("it is a {}, and a block walk is of triangles", name_of(primitive.kind));
  if (auto why = explain_culling(primitive, target, choice)) return why->text;
  if (primitive.is_clipped)
    return "it reaches out of the clip volume, and a block walk is of triangles that lie within";
  if (choice.triangle_algorithm != TriangleAlgorithm::edge_functions)
    return fmt::format("as triangle.algorithm={} has it no edge functions are asked",
                       name_of(choice.triangle_algorithm));
  return "";
}

}  // namespace

PrimitiveBlocks blocks_of(const ScenePrimitive& primitive, const Target& target,
                          const CoverageChoice& choice, std::span<const int> sizes) {
  PrimitiveBlocks blocks;
  blocks.absence = absence_of(primitive, target, choice);
  if (!blocks.absence.empty()) return blocks;
  for (std::size_t i = 0; i < blocks.triangle.size(); ++i)
    blocks.triangle[i] = snapped_position(primitive, i, choice, target);
  const bool by_sample = sampling_of(primitive, target, choice) == Unsampled::by_each_sample;
  blocks.places = by_sample ? positions_of(target, choice, {}) : SamplePositions{centre_of_pixel()};
  const TieRule ties = choice.rows == RowOrder::top_down ? turned_over(choice.ties) : choice.ties;
  blocks.walk = walk_blocks(
      blocks.triangle, {drawable_bounds(*primitive.state, target), sizes, blocks.places}, ties);
  if (!blocks.walk.blocks.empty()) return blocks;
  const auto& t = blocks.triangle;
  blocks.absence =
      cross(t[0], t[1], t[2]) == 0 ? "it has no area" : "no sample lies in its bounding box";
  return blocks;
}

namespace {

// Whether kernels are in use and implement the choice's triangles, or its lines of this width.
bool walks_triangles(const CoverageChoice& choice) {
  return kernels_are_used() && choice.triangle_algorithm == TriangleAlgorithm::edge_functions;
}

bool walks_lines(const CoverageChoice& choice, Fixed width) {
  const TieRule* ties = choice.line.boundary->ties;
  return kernels_are_used() && width == Fixed::from_integer(1) &&
         choice.line.algorithm == LineAlgorithm::diamond_exit && ties != nullptr &&
         ties->kind == TieRule::Kind::perturbed;
}

}  // namespace

bool is_walked(const ScenePrimitive& primitive, const CoverageChoice& choice) {
  const bool is_triangle = primitive.kind == PrimitiveKind::triangle && walks_triangles(choice);
  const bool is_line =
      primitive.kind == PrimitiveKind::line && walks_lines(choice, primitive.state->line_width);
  if (!is_triangle && !is_line) return false;
  if (choice.rows != RowOrder::bottom_up) return false;
  return std::all_of(primitive.vertices.begin(),
                     primitive.vertices.begin() + vertices_of(primitive.kind),
                     [&](const Vertex* vertex) {
                       return !vertex->clip && is_raw_point(vertex->position) &&
                              is_raw_point(choice.snap(vertex->position));
                     });
}

std::vector<PixelPosition> found_triangle_pixels(const Triangle& triangle,
                                                 const PixelBounds& bounds,
                                                 const CoverageChoice& choice) {
  if (walks_triangles(choice) && std::all_of(triangle.begin(), triangle.end(), is_raw_point))
    return walked_triangle_pixels(triangle, bounds, choice.ties);
  return triangle_pixels(triangle, bounds, choice.triangle_algorithm, choice.ties);
}

Point centred(Point vertex, Point within) {
  const Point centre = centre_of_pixel();
  return {vertex.x + centre.x - within.x, vertex.y + centre.y - within.y};
}

void sort_by_rows(std::vector<PixelPosition>& pixels) {
  const auto reads_before = [](PixelPosition a, PixelPosition b) {
    return std::tie(a.y, a.x) < std::tie(b.y, b.x);
  };
  if (!std::ranges::is_sorted(pixels, reads_before)) std::ranges::sort(pixels, reads_before);
}

bool covers_just(std::span<const PixelPosition> pixels, const Triangle& triangle,
                 const PixelBounds& bounds, const CoverageChoice& choice) {
  if (walks_triangles(choice) && std::all_of(triangle.begin(), triangle.end(), is_raw_point))
    return walks_just(pixels, triangle, bounds, choice.ties);
  auto covered = triangle_pixels(triangle, bounds, choice.triangle_algorithm, choice.ties);
  sort_by_rows(covered);
  return std::ranges::equal(covered, pixels);
}

std::vector<PixelPosition> found_tied_pixels(const Triangle& triangle, const PixelBounds& bounds) {
  if (kernels_are_used() && std::all_of(triangle.begin(), triangle.end(), is_raw_point))
    return walked_tied_pixels(triangle, bounds);
  return tied_triangle_pixels(triangle, bounds);
}

std::vector<PixelPosition> found_line_pixels(const Segment& segment, Fixed width,
                                             const PixelBounds& bounds,
                                             const CoverageChoice& choice) {
  if (walks_lines(choice, width) && is_raw_point(segment.a) && is_raw_point(segment.b))
    return walked_line_pixels(segment, bounds, *choice.line.boundary->ties);
  return line_pixels(segment, width, bounds, choice.line, choice.ties);
}

namespace {

using Pixels = std::vector<PixelPosition>;

ClipPlanes planes_of(const Viewport& viewport, ClipMethod method) {
  if (method == ClipMethod::guard_band) return guard_band();
  return method == ClipMethod::doubled_sides ? doubled_sides_of(viewport) : sides_of(viewport);
}

Viewport box_of(const PixelBounds& bounds) {
  return {bounds.x_min, bounds.y_min, bounds.x_max - bounds.x_min + 1,
          bounds.y_max - bounds.y_min + 1};
}

// The pixels of the polygon, split into a fan round its first vertex.
Pixels fan_pixels(const std::vector<ClipPolygonVertex>& polygon, const PixelBounds& bounds,
                  Point within, const CoverageChoice& choice) {
  std::vector<Point> v;
  for (const ClipPolygonVertex& vertex : polygon)
    v.push_back(centred(choice.snap(vertex.position), within));
  Pixels pixels;
  for (std::size_t i = 1; i + 1 < v.size(); ++i) {
    const Pixels part =
        triangle_pixels({v[0], v[i], v[i + 1]}, bounds, choice.triangle_algorithm, choice.ties);
    pixels.insert(pixels.end(), part.begin(), part.end());
  }
  // A snapped fan may overlap itself.
  std::sort(pixels.begin(), pixels.end());
  pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
  return pixels;
}

}  // namespace

Pixels clipped_pixels(const ClippedTriangle& clipped, const PixelBounds& bounds, Point within,
                      const CoverageChoice& choice) {
  const auto& [triangle, viewport] = clipped;
  switch (choice.clip) {
    case ClipMethod::homogeneous:
    case ClipMethod::depth_ignored:
      return clipped_triangle_pixels(triangle, viewport, bounds, choice.ties, within,
                                     choice.clip == ClipMethod::homogeneous);
    case ClipMethod::sides_ignored:
      return clipped_triangle_pixels(triangle, box_of(bounds), bounds, choice.ties, within, true);
    case ClipMethod::polygon:
    case ClipMethod::guard_band:
    case ClipMethod::doubled_sides:
      return fan_pixels(clip_polygon(triangle, planes_of(viewport, choice.clip), 1),
                        common_part(bounds, pixels_in(viewport)), within, choice);
    case ClipMethod::discarded:
      break;
  }
  return {};
}

}  // namespace edgecase
