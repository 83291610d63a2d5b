// SPDX-License-Identifier: MIT
//
// Triangles: the fill rule, edges that two of them share, and the way they face. Other ways to fill
// them are in rules/coverage/triangle_algorithm.h.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "exact/homogeneous.h"
#include "model/scene.h"
#include "rules/coverage/tie_rule.h"
#include "rules/rule.h"

namespace edgecase {

// Essay: The fill rule
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

// True if p lies to the left of a -> b, and no move of a and b by less than `reach` puts it on the
// segment between them. The line through a short edge may turn past it all the same. Where this is
// so of all edges of a polygon, p lies inside after every such move of the vertices: while they
// move there, no edge passes over it.
bool left_and_apart(Point a, Point b, Point p, Fixed reach);

// The name of the edge a -> b of a counter-clockwise triangle: "left", "right", "bottom" or "top".
const char* edge_kind(Point a, Point b);

// Essay: Shared edges
//
// Shared edges: no hole and no double hit between two triangles (GL 4.6 core, 14.6.1).
//
// Two triangles lie on opposite sides of an edge with bit-identical ends. Exactly one of them
// produces a sample on that edge. OpenGL mandates nothing else about ties.
//
// Snapping moves both triangles alike. The promise therefore holds for every sample that lies
// inside their union under all allowed moves. Near the ends of the edge other triangles take part.
// Nothing is promised there about two triangles alone.

Rule shared_edge_rule();

struct SharedEdge {
  Point a, b;         // the common ends, in the order of the first triangle made counter-clockwise
  Point left, right;  // the third vertices of the first and of the second triangle
};

// The common edge of two triangles that lie on opposite sides of it, if they have one.
std::optional<SharedEdge> shared_edge(const Triangle& first, const Triangle& second);

// True if the sample lies strictly inside the other four edges, for all moves of the vertices by
// less than `reach`.
bool lies_between(const SharedEdge& edge, Point sample, Fixed reach);

// True if the two triangles must hit the sample exactly once, for all moves of their vertices by
// less than `reach`: the sample may be on either side of the edge and is strictly inside the other
// four.
bool must_hit_once(const SharedEdge& edge, Point sample, Fixed reach);

// Essay: Front and back
//
// Front and back faces (GL 4.6 core, 14.6.1). The sign of a triangle's area in the window says
// which way it faces. The draw says which order of vertices is the front. Culling drops triangles
// by their facing. The stencil test has a state for each facing.
//
//   area = 1/2 sum of (x_i y_i+1 - x_i+1 y_i)    above 0: counter-clockwise, y up
//
// Only the sign counts, and it is exact. A triangle of hardly any area still faces one way.

Rule polygon_facing_rule();  // polygon.facing

enum class FacingMethod {
  as_set,
  reversed,             // y is assumed to run downwards
  always_ccw,           // the draw's front face is ignored
  not_culled,           // nothing is dropped
  of_cut_vertices,      // by the area that whole coordinates have, cut or
  of_rounded_vertices,  // rounded
};
template <>
inline constexpr auto kNames<FacingMethod> = std::to_array<TabledAlternative<FacingMethod>>(
    {{FacingMethod::as_set, "as-set", Openness::mandated,
      "a polygon faces the front if its winding in the window is the one that the draw sets"},
     {FacingMethod::reversed, "reversed", Openness::illegal,
      "y is taken to run downward, which exchanges front and back"},
     {FacingMethod::always_ccw, "always-ccw", Openness::illegal,
      "counter-clockwise polygons face the front, whatever the draw sets"},
     {FacingMethod::not_culled, "not-culled", Openness::illegal, "no polygon is dropped"},
     {FacingMethod::of_cut_vertices, "of-cut-vertices", Openness::illegal,
      "the area's sign is that of vertices cut to whole pixels"},
     {FacingMethod::of_rounded_vertices, "of-rounded-vertices", Openness::illegal,
      "the area's sign is that of vertices rounded to whole pixels"}});

// Points and lines face the front.
bool is_front_facing(const ScenePrimitive& primitive,
                     const std::array<HomogeneousPoint, 3>& positions, FacingMethod method);

// True if the primitive is dropped before it is rasterized. `positions`: its vertices, snapped.
bool is_culled(const ScenePrimitive& primitive, const std::array<HomogeneousPoint, 3>& positions,
               FacingMethod method);

}  // namespace edgecase
