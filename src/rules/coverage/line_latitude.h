// SPDX-License-Identifier: MIT
//
// What OpenGL accepts as a line (GL 4.6 core, 14.5.1, the relaxed rules; rulings 1, 2, 12 and 15).
//
// The predicate of the diamond-exit rule lives in diamond_exit.h; here is how far another algorithm
// may stray from it, judged from a segment and the pixels that were drawn of it, and nothing else.
// Where the ends are known to within a reach only, a clause is broken when it is for every place of
// theirs.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "rules/coverage/diamond_reach.h"

namespace edgecase {

// A line of which the pixels inside `bounds` are seen.
struct SeenLine {
  Segment segment;
  int width = 1;  // rounded, see line_algorithm.h
  PixelBounds bounds;
  Fixed reach = {};  // of its ends, see diamond_reach.h
  // Who finds the fragments of the diamond-exit rule, with ties as `left-bottom` has them, within
  // bounds, of a segment whose ends are known. Null: the predicate.
  std::vector<PixelPosition> (*find)(const Segment&, const PixelBounds&) = nullptr;
};

// A broken clause of rulings 1, 2 and 12, in words; empty when every clause holds, or when the line
// is drawn as the diamond-exit rule has it with its ends moved, at ties, in another direction than
// the text's. `drawn` are the pixels that a renderer produced of the line inside the bounds, each
// as often as it came.
std::string broken_line_clause(const SeenLine& line, std::span<const PixelPosition> drawn);

// Has the diamond-exit rule no fragment of the segment in the bounds or near them, wherever its
// ends are? Then ruling 2 holds in place of ruling 1.
bool is_unseen(const SeenLine& line);

}  // namespace edgecase
