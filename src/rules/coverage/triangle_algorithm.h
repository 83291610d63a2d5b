// SPDX-License-Identifier: MIT
//
// Algorithms that draw triangles.
//
// OpenGL says which samples lie inside a triangle. It leaves the method to the implementation, as
// long as rulings 4 and 5 hold. Edge functions of integers are exact. Scan conversion rounds, and
// so do edge functions of floats, with which a centre at a hair from an edge falls on the wrong
// side, or on that of both triangles beside it. Both are listed here so that a renderer which uses
// them can be distinguished from one that is merely wrong.
#pragma once

#include <array>
#include <vector>

#include "exact/fixed.h"
#include "rules/coverage/tie_rule.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {

enum class TriangleAlgorithm {
  edge_functions,
  scan,         // scan conversion in single precision; ties follow from its truncation
  float_edges,  // edge functions in single precision
};
template <>
inline constexpr auto kNames<TriangleAlgorithm> = std::to_array<
    TabledAlternative<TriangleAlgorithm>>(
    {{TriangleAlgorithm::edge_functions, "edge-functions", Openness::open,
      "exact; samples on an edge follow triangle.fill-rule"},
     {TriangleAlgorithm::scan, "scan", Openness::open,
      "scan conversion in single precision, row by row upward, with rounded slopes; right and "
      "bottom edges own the samples on them; vertices that are divided by w and not snapped are "
      "first rounded to the nearest multiple of 2^-16"},
     {TriangleAlgorithm::float_edges, "float-edges", Openness::open,
      "edge functions (b.x - a.x)(p.y - a.y) - (b.y - a.y)(p.x - a.x), each operation rounded to "
      "single precision, the vertices counter-clockwise; samples where one is 0 follow "
      "triangle.fill-rule"}});

// True if the algorithm uses a tie rule.
bool has_tie_rule(TriangleAlgorithm algorithm);

Rule triangle_algorithm_rule();

// The part of the bounds in which a triangle's samples can lie, plus a pixel on each side.
PixelBounds sample_bounds(const Triangle& triangle, const PixelBounds& bounds);

// The pixels within `bounds`, each once, in no particular order. `ties` is for algorithms with a
// tie rule.
std::vector<PixelPosition> triangle_pixels(const Triangle& triangle, const PixelBounds& bounds,
                                           TriangleAlgorithm algorithm, const TieRule& ties);

// The pixels within `bounds` for which the ownership of edges matters: the sample lies on an edge
// of the triangle. All TieRules agree on other pixels.
std::vector<PixelPosition> tied_triangle_pixels(const Triangle& triangle,
                                                const PixelBounds& bounds);

}  // namespace edgecase
