// SPDX-License-Identifier: MIT
#include "raster/coverage_stages.h"

#include <algorithm>
#include <tuple>

#include "kernels/covered_pixels_kernel.h"
#include "kernels/edge_functions.h"
#include "kernels/kernel_use.h"
#include "rules/coverage/clip_polygon.h"
#include "rules/coverage/triangle_algorithm.h"

namespace edgecase {

bool walks_triangles(const CoverageChoice& choice) {
  return kernels_are_used() && choice.triangle_algorithm == TriangleAlgorithm::edge_functions;
}

bool walks_lines(const CoverageChoice& choice, Fixed width) {
  const TieRule* ties = choice.line.boundary->ties;
  return kernels_are_used() && width == Fixed::from_integer(1) &&
         choice.line.algorithm == LineAlgorithm::diamond_exit && ties != nullptr &&
         ties->kind == TieRule::Kind::perturbed;
}

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

// The extent of a guard band in pixels: the whole range of exact coordinates.
constexpr int kGuardBand = static_cast<int>(Fixed::kMaxCoordinate);

ClipPlanes planes_of(const Viewport& viewport, ClipMethod method) {
  if (method == ClipMethod::guard_band)
    return {true, -kGuardBand, -kGuardBand, kGuardBand, kGuardBand};
  return {true, viewport.x, viewport.y, viewport.x + viewport.width, viewport.y + viewport.height};
}

Point centred(Point vertex, Point within) {
  const Point centre = centre_of_pixel();
  return {vertex.x + centre.x - within.x, vertex.y + centre.y - within.y};
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
    case ClipMethod::polygon:
    case ClipMethod::guard_band:
      return fan_pixels(clip_polygon(triangle, planes_of(viewport, choice.clip), 1),
                        common_part(bounds, pixels_in(viewport)), within, choice);
    case ClipMethod::discarded:
      break;
  }
  return {};
}

}  // namespace edgecase
