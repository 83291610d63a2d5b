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
#include "exact/homogeneous.h"
#include "model/sampling.h"
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

// ------------------------------------------------------------- scan conversion in single precision
//
// Before edge functions, software rasterizers walked the rows: on each, they evaluated the two
// edges that the row crosses and drew the pixels between them. Mesa's softpipe still does. In
// single precision, an edge has a slope rounded once and a start rounded twice, the long edge
// starts again at the third vertex, and two triangles that share an edge from different vertices
// need not agree on its position: samples on it are hit twice or not at all.

// The pixels within `bounds` that are drawn, row by row. Rows are walked upward; the vertices' `x`
// and `y` must be exact in single precision.
std::vector<PixelPosition> scanned_triangle_pixels(const Triangle& triangle,
                                                   const PixelBounds& bounds);

// ---------------------------------------------------------- triangles whose vertices are quotients
//
// An edge function is the determinant of three points with their w as third coordinates: its sign
// is known without a division (Olano and Greer, "Triangle Scan Conversion using 2D Homogeneous
// Coordinates", 1997). All w are positive here, so the determinant has the sign of the divided
// triangle's, and its growth to the right and up is the edge's normal, times a positive number.
// Ties are as in triangle_fill.h.

using HomogeneousTriangle = std::array<HomogeneousPoint, 3>;

// The nearest triangle whose coordinates are multiples of 2^-16.
Triangle nearest_triangle(const HomogeneousTriangle& triangle);

// True if the triangle covers the sample, or the centre of pixel (x, y). A sample's w is at most
// 2^16.
bool triangle_covers(const HomogeneousTriangle& triangle, const HomogeneousPoint& sample,
                     const TieRule& ties);
inline bool triangle_covers(const HomogeneousTriangle& triangle, int x, int y,
                            const TieRule& ties) {
  return triangle_covers(triangle, homogeneous_centre(x, y), ties);
}

// The pixels within `bounds` whose sample, at position `within`, is covered; each once, in no
// particular order. Algorithms that round use the nearest triangle.
std::vector<PixelPosition> triangle_pixels(const HomogeneousTriangle& triangle,
                                           const PixelBounds& bounds, TriangleAlgorithm algorithm,
                                           const TieRule& ties, Point within = centre_of_pixel());

// ----------------------------------------------------------- pixels within three edges, by walking
//
// An edge function is linear in its sample: it grows by the same number from each pixel to the
// next, which is exact in integers. So each is evaluated once and then only added to. The samples
// of a row that are inside are consecutive, since three half-planes meet in a convex region, and
// the row ends with them. triangle_covers and its homogeneous form define the inside; this finds
// the same pixels faster.

// The integers must be wide enough for the function at every sample of the walk and one step
// beyond.
template <class Integer>
struct WalkedEdge {
  Integer value = 0;    // at the sample of the walk's first pixel; positive inside
  Integer right = 0;    // its growth from one column to the next
  Integer up = 0;       // its growth from one row to the next
  bool is_own = false;  // samples on the edge are inside

  bool has_inside() const { return value > 0 || (value == 0 && is_own); }
};

// The edges start at the lower left pixel of `bounds`. Rows from the bottom, each from the left.
template <class Integer>
std::vector<PixelPosition> walk_edges(std::array<WalkedEdge<Integer>, 3> edges,
                                      const PixelBounds& bounds) {
  std::vector<PixelPosition> pixels;
  for (int y = bounds.y_min; y <= bounds.y_max; ++y) {
    auto [a, b, c] = edges;
    bool is_inside = false;
    for (int x = bounds.x_min; x <= bounds.x_max; ++x) {
      const bool was_inside = is_inside;
      is_inside = a.has_inside() && b.has_inside() && c.has_inside();
      if (is_inside) pixels.push_back({x, y});
      if (was_inside && !is_inside) break;
      for (WalkedEdge<Integer>* edge : {&a, &b, &c}) edge->value += edge->right;
    }
    for (WalkedEdge<Integer>& edge : edges) edge.value += edge.up;
  }
  return pixels;
}

}  // namespace edgecase
