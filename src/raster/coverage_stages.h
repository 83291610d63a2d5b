// SPDX-License-Identifier: MIT
//
// The exact rasterizer's coverage stage: kernels, and triangles with a vertex outside the clip
// volume.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "exact/fixed.h"
#include "model/scene.h"
#include "rules/choices.h"
#include "rules/coverage/block_walk.h"
#include "rules/rule.h"

namespace edgecase {

// Properties of single primitives that precede their pixels: facing, culling, and the blocks of a
// block walk.

// Which way a scene's triangles face under a choice of rules, with vertices snapped as for
// coverage, and whether they are culled.

// Points and lines are always front-facing.
bool is_front_facing(const ScenePrimitive& primitive, const Target& target,
                     const CoverageChoice& choice);

// Whether the primitive is culled and so makes no fragments.
bool is_culled(const ScenePrimitive& primitive, const Target& target, const CoverageChoice& choice);

// Why the primitive is culled, with its outline; nothing if it is not.
std::optional<Explanation> explain_culling(const ScenePrimitive& primitive, const Target& target,
                                           const CoverageChoice& choice);

// How a block walk would find a scene's triangles under a choice of rules. The rasterizer does not
// walk blocks; a walk covers the same pixels and shows how few need a test.
struct PrimitiveBlocks {
  HomogeneousTriangle triangle{};  // with the vertices used for coverage
  SamplePositions places;          // of the samples tested in each pixel
  BlockWalk walk;
  std::string absence;  // why there is no walk, without a full stop; empty if there is one
};

// The block walk of a primitive within the pixels that its draw may write, ignoring the sample
// mask. `sizes` of blocks, as for BlockGrid.
PrimitiveBlocks blocks_of(const ScenePrimitive& primitive, const Target& target,
                          const CoverageChoice& choice, std::span<const int> sizes);

// Moves a vertex so that the point `within` each pixel falls on the pixel's centre.
Point centred(Point vertex, Point within);

// This is the one place that knows for which choices of rules the kernels can replace the
// predicates.

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
