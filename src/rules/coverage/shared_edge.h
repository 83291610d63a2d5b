// SPDX-License-Identifier: MIT
//
// Shared edges: no hole and no double hit between two triangles (GL 4.6 core, 14.6.1).
//
// Two triangles lie on opposite sides of an edge with bit-identical ends. Exactly one of them
// produces a sample on that edge. OpenGL mandates nothing else about ties.
//
// Snapping moves both triangles alike. The promise therefore holds for every sample that lies
// inside their union under all allowed moves. Near the ends of the edge other triangles take part.
// Nothing is promised there about two triangles alone.
#pragma once

#include <optional>

#include "rules/coverage/triangle_fill.h"

namespace edgecase {

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

}  // namespace edgecase
