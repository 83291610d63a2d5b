// SPDX-License-Identifier: MIT
//
// Algorithms that draw triangles.
//
// OpenGL says which samples lie inside a triangle. It leaves the method to the implementation, as
// long as rulings 4 and 5 hold. Edge functions are exact. Scan conversion rounds. It is listed here
// so that a renderer which uses it can be told from one that is merely wrong.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "exact/pixel.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {

enum class TriangleAlgorithm {
  edge_functions,
  scan,  // scan conversion in single precision, ties as its truncation has them
};

std::span<const TriangleAlgorithm> all_triangle_algorithms();
// "edge-functions", "scan".
const char* name_of(TriangleAlgorithm algorithm);
// False when there is none of that name.
bool parse_name(std::string_view name, TriangleAlgorithm& algorithm);
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

}  // namespace edgecase
