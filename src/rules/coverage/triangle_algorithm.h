// SPDX-License-Identifier: MIT
//
// Algorithms that draw triangles.
//
// OpenGL says which samples lie inside a triangle. It leaves the method to the implementation, as
// long as rulings 4 and 5 hold. Edge functions are exact. Scan conversion rounds. It is listed here
// so that a renderer which uses it can be told from one that is merely wrong.
#pragma once

#include <array>
#include <vector>

#include "exact/homogeneous.h"
#include "exact/pixel.h"
#include "model/sampling.h"
#include "rules/coverage/tie_rule.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {

enum class TriangleAlgorithm {
  edge_functions,
  scan,  // scan conversion in single precision, ties as its truncation has them
};
template <>
inline constexpr auto kNames<TriangleAlgorithm> = std::to_array<
    TabledAlternative<TriangleAlgorithm>>(
    {{TriangleAlgorithm::edge_functions, "edge-functions", Openness::open,
      "exact; samples on an edge follow triangle.fill-rule"},
     {TriangleAlgorithm::scan, "scan", Openness::open,
      "scan conversion in single precision, row by row upward, with rounded slopes; right and "
      "bottom edges own the samples on them; vertices that are divided by w and not snapped are "
      "first rounded to the nearest multiple of 2^-16"}});

// Does the algorithm ask for a tie rule?
bool has_tie_rule(TriangleAlgorithm algorithm);

Rule triangle_algorithm_rule();

// The part of the bounds in which a triangle's samples can lie, and a pixel more on each side.
PixelBounds sample_bounds(const Triangle& triangle, const PixelBounds& bounds);

// The pixels within `bounds`, each once, in no particular order. `ties` is for algorithms that have
// a tie rule.
std::vector<PixelPosition> triangle_pixels(const Triangle& triangle, const PixelBounds& bounds,
                                           TriangleAlgorithm algorithm, const TieRule& ties);

// The pixels within `bounds` at which it matters whom edges belong to: the sample lies in the
// triangle, on an edge of it. At others all TieRules decide alike.
std::vector<PixelPosition> tied_triangle_pixels(const Triangle& triangle,
                                                const PixelBounds& bounds);

// ------------------------------------------------------------ scan conversion in single precision
//
// Before edge functions, software rasterizers walked the rows: on each, the two edges that it
// crosses are evaluated, and the pixels between them are drawn. Mesa's softpipe still does. In
// single precision an edge has a slope that is rounded once and a start that is rounded twice, the
// long edge starts anew where the third vertex lies, and two triangles that share an edge from
// different vertices need not agree where it runs: samples on it are hit twice or not at all.

// The pixels within `bounds` that are drawn, row by row. Rows are walked upward; `x` and `y` of the
// vertices must be exact in single precision.
std::vector<PixelPosition> scanned_triangle_pixels(const Triangle& triangle,
                                                   const PixelBounds& bounds);

// ------------------------------------------------------------ triangles whose vertices are
// quotients
//
// An edge function is the determinant of three points, written with their w as third coordinates:
// nothing needs to be divided to know its sign (Olano and Greer, "Triangle Scan Conversion using 2D
// Homogeneous Coordinates", 1997). All w are positive here, so the determinant has the sign of the
// divided triangle's, and its growth to the right and up is the edge's normal, times a positive
// number. Ties are what they are in triangle_fill.h.

using HomogeneousTriangle = std::array<HomogeneousPoint, 3>;

// The nearest triangle whose coordinates are multiples of 2^-16.
Triangle nearest_triangle(const HomogeneousTriangle& triangle);

// Does the triangle cover the sample, or the centre of pixel (x, y)? A sample's w is at most 2^16.
bool triangle_covers(const HomogeneousTriangle& triangle, const HomogeneousPoint& sample,
                     const TieRule& ties);
inline bool triangle_covers(const HomogeneousTriangle& triangle, int x, int y,
                            const TieRule& ties) {
  return triangle_covers(triangle, homogeneous_centre(x, y), ties);
}

// The pixels within `bounds` whose sample, at `within` of the pixel, is covered, each once, in no
// particular order. Algorithms that round get the nearest triangle.
std::vector<PixelPosition> triangle_pixels(const HomogeneousTriangle& triangle,
                                           const PixelBounds& bounds, TriangleAlgorithm algorithm,
                                           const TieRule& ties, Point within = centre_of_pixel());

// --------------------------------------------------------- pixels within three edges, by walking
//
// An edge function is linear in its sample: from one pixel to the next it grows by the same number,
// which is exact in integers. So each is evaluated once and then only added to, and a row ends
// where the samples inside, which are consecutive since three half-planes meet in a convex region,
// end. triangle_covers and its homogeneous form say what is inside; this finds the same pixels
// faster.

// Integers are wide enough for the function at every sample of the walk and one step beyond.
template <class Integer>
struct WalkedEdge {
  Integer value = 0;    // at the sample of the walk's first pixel; positive inside
  Integer right = 0;    // its growth from one column to the next
  Integer up = 0;       // its growth from one row to the next
  bool is_own = false;  // are samples on the edge inside?

  bool has_inside() const { return value > 0 || (value == 0 && is_own); }
};

// The edges' first pixel is the lower left one of `bounds`. Rows from the bottom, each from the
// left.
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
