// SPDX-License-Identifier: MIT
//
// The exact rasterizer's coverage stage: kernels, and triangles with a vertex outside the clip
// volume.
#pragma once

#include <span>
#include <vector>

#include "exact/pixel.h"
#include "model/scene.h"
#include "rules/choices.h"

namespace edgecase {

// This is the one place that knows for which choices of rules the kernels can replace the
// predicates.

// Whether kernels are in use and implement the choice's triangles, or its lines of this width.
bool walks_triangles(const CoverageChoice& choice);
bool walks_lines(const CoverageChoice& choice, Fixed width);

// Whether kernels find this primitive's samples. If so, its vertices are given in the window and
// its target is not turned upside down.
bool is_walked(const ScenePrimitive& primitive, const CoverageChoice& choice);

// As in rules/coverage/triangle_algorithm.h and line_algorithm.h, by kernels or by predicates. The
// bounds lie within the window; pixels come in no particular order.
std::vector<PixelPosition> found_triangle_pixels(const Triangle& triangle,
                                                 const PixelBounds& bounds,
                                                 const CoverageChoice& choice);
std::vector<PixelPosition> found_tied_pixels(const Triangle& triangle, const PixelBounds& bounds);
std::vector<PixelPosition> found_line_pixels(const Segment& segment, Fixed width,
                                             const PixelBounds& bounds,
                                             const CoverageChoice& choice);

// Sorts by row, then column. Most lists already are, and a check is much cheaper than a sort.
void sort_by_rows(std::vector<PixelPosition>& pixels);

// Whether the triangle covers exactly these pixels: distinct, sorted by row, then column.
bool covers_just(std::span<const PixelPosition> pixels, const Triangle& triangle,
                 const PixelBounds& bounds, const CoverageChoice& choice);

// Triangles with a vertex outside the clip volume.

// The triangle to rasterize and its viewport, either as given or both turned upside down.
struct ClippedTriangle {
  UnclippedTriangle triangle;
  Viewport viewport;
};

// The distinct pixels within `bounds` whose sample, at `within` in the pixel, is covered, in no
// particular order. Nothing is snapped if the choice's clipping makes no vertices.
std::vector<PixelPosition> clipped_pixels(const ClippedTriangle& clipped, const PixelBounds& bounds,
                                          Point within, const CoverageChoice& choice);

}  // namespace edgecase
