// SPDX-License-Identifier: MIT
//
// What OpenGL accepts as a line (GL 4.6 core, 14.5.1, the relaxed rules; rulings 1, 2, 12 and 15).
//
// The predicate of the diamond-exit rule stands in diamond_exit.h. This file decides how far
// another algorithm may deviate from it, only from a segment and its drawn pixels. If the ends are
// known only to within a reach, a clause is broken if it is broken for all ends within the reach.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "exact/fixed.h"
#include "rules/coverage/segment.h"

namespace edgecase {

// A line and the bounds inside which its pixels are visible.
struct SeenLine {
  Segment segment;
  int width = 1;  // rounded, see line_algorithm.h
  PixelBounds bounds;
  Fixed reach = {};  // of its ends
  // Finds the fragments of the diamond-exit rule within bounds, with ties as in `left-bottom`, for
  // a segment whose ends are known. Null: the predicate.
  std::vector<PixelPosition> (*find)(const Segment&, const PixelBounds&) = nullptr;
};

// A broken clause of rulings 1, 2 and 12, as text; empty if the line satisfies every clause, or is
// drawn by the diamond-exit rule with its ends moved, at ties, in another direction than in the
// text. `drawn` are the pixels that a renderer produced of the line inside the bounds, each as
// often as it was produced.
std::string broken_line_clause(const SeenLine& line, std::span<const PixelPosition> drawn);

// True if the diamond-exit rule has no fragment of the segment in or near the bounds, for all ends
// within reach. Then ruling 2 applies instead of ruling 1.
bool is_unseen(const SeenLine& line);

}  // namespace edgecase
