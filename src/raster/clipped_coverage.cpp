// SPDX-License-Identifier: MIT
#include "raster/clipped_coverage.h"

#include <algorithm>

#include "rules/coverage/clip_polygon.h"
#include "rules/coverage/triangle_algorithm.h"

namespace edgecase {
namespace {

using Pixels = std::vector<PixelPosition>;

// How far a guard band reaches, in pixels: all that exact coordinates hold.
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

// The polygon as a fan round its first vertex.
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
  // Snapped, a fan may overlap itself.
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
