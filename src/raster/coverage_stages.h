// SPDX-License-Identifier: MIT
//
// The exact rasterizer's coverage stage by kernels, and where a vertex lies outside the clip
// volume.
#pragma once

#include <span>
#include <vector>

#include "exact/pixel.h"
#include "model/scene.h"
#include "rules/choices.h"

namespace edgecase {

// Where the kernels find a primitive's pixels in place of the predicates: the one place that knows
// which choices of rules they hold.

// Do kernels know the choice's triangles, and its lines of width 1, and are they used?
bool walks_triangles(const CoverageChoice& choice);
bool walks_lines(const CoverageChoice& choice, Fixed width);

// Do kernels find this primitive's samples? Its vertices are then given in the window, and its
// target is seen the right way up.
bool is_walked(const ScenePrimitive& primitive, const CoverageChoice& choice);

// As in rules/coverage/triangle_algorithm.h and line_algorithm.h, by kernels or by predicates. The
// bounds lie within the window; pixels are in no particular order.
std::vector<PixelPosition> found_triangle_pixels(const Triangle& triangle,
                                                 const PixelBounds& bounds,
                                                 const CoverageChoice& choice);
std::vector<PixelPosition> found_tied_pixels(const Triangle& triangle, const PixelBounds& bounds);
std::vector<PixelPosition> found_line_pixels(const Segment& segment, Fixed width,
                                             const PixelBounds& bounds,
                                             const CoverageChoice& choice);

// By row, column. Most are found row by row, and looking is much cheaper than sorting.
void sort_by_rows(std::vector<PixelPosition>& pixels);

// Does the triangle cover just these pixels, which are sorted by row, column, none twice?
bool covers_just(std::span<const PixelPosition> pixels, const Triangle& triangle,
                 const PixelBounds& bounds, const CoverageChoice& choice);

// The exact rasterizer's coverage stage where a vertex lies outside the clip volume.

// The triangle to rasterize and its viewport: as they are, or turned upside down.
struct ClippedTriangle {
  UnclippedTriangle triangle;
  Viewport viewport;
};

// The pixels within `bounds` whose sample, at `within` of the pixel, is covered, each once, in no
// particular order. Where the choice makes no vertices, none are snapped.
std::vector<PixelPosition> clipped_pixels(const ClippedTriangle& clipped, const PixelBounds& bounds,
                                          Point within, const CoverageChoice& choice);

}  // namespace edgecase
