// SPDX-License-Identifier: MIT
//
// Triangles: point sampling and the fill rule (GL 4.6 core, 14.6.1).
//
// A triangle produces a fragment for each pixel whose centre lies inside it. Three edge functions
// say on which side of each edge the centre lies. They are cross products in 62-bit integers:
//
//   E(s) = (b - a) x (s - a)    of the edge a -> b, vertices counter-clockwise
//   above 0: inside; below 0: outside; 0: exactly on the edge
//
// A tie rule decides over a centre exactly on an edge. OpenGL demands only that exactly one of two
// triangles which share the edge gets the centre. Each of the eight perturbed rules does so. Such a
// rule moves every sample by an arbitrarily small step in one direction, and by a much smaller one
// in the other. No sample then lies on an edge. `left-top` moves by (e, -e^2): right, and much less
// down. It owns left edges, then top edges, y up. Where y points down, the common name "top-left
// rule" means `left-bottom`.
//
// Both windings are drawn alike. A triangle without area draws nothing.
#pragma once

#include <array>

#include "rules/coverage/explain.h"
#include "rules/coverage/tie_rule.h"
#include "rules/rule.h"

namespace edgecase {

using Triangle = std::array<Point, 3>;

Rule triangle_fill_rule();

// Twice the signed area in units of 2^-32, positive when counter-clockwise (y up).
std::int64_t doubled_area(const Triangle& triangle);

// The same triangle with vertices in counter-clockwise order; in any order if it has no area.
Triangle counter_clockwise(const Triangle& triangle);

// True if the triangle produces the fragment of pixel (x, y).
bool triangle_covers(const Triangle& triangle, int x, int y, const TieRule& ties);

// Why the sample, or the centre of pixel (x, y), is covered or not: a sentence with numbers.
Explanation explain_triangle(const Triangle& triangle, Point sample, const TieRule& ties);
inline Explanation explain_triangle(const Triangle& triangle, int x, int y, const TieRule& ties) {
  return explain_triangle(triangle, pixel_centre(x, y), ties);
}

// Whether the specification's latitude permits the sample to be covered, and to be uncovered. Each
// vertex may move by less than `reach` in x and in y, and ties on edges go either way. reach: more
// than 0, at most a pixel.
bool triangle_possibly_covered(const Triangle& triangle, Point sample, Fixed reach);
bool triangle_possibly_uncovered(const Triangle& triangle, Point sample, Fixed reach);

// True if p lies strictly to the left of a -> b for every move of a and b by less than `reach`.
bool robustly_left(Point a, Point b, Point p, Fixed reach);

}  // namespace edgecase
