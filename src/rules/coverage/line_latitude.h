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

#include "exact/pixel.h"
#include "rules/coverage/segment.h"

namespace edgecase {

// A line of which the pixels inside `bounds` are seen.
struct SeenLine {
  Segment segment;
  int width = 1;  // rounded, see line_algorithm.h
  PixelBounds bounds;
  Fixed reach = {};  // of its ends
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

// -------------------------------------------------------------------- ends known to within a reach
//
// Where a vertex lands may depend on roundings that the specification leaves open (ruling 15). A
// renderer may then draw what the rule has for any place of the ends. No point of the segment moves
// by more than the ends do, so a diamond can only be met by a moved segment if the segment itself
// meets the diamond grown by twice the reach, and is met by every one if it meets the diamond
// shrunk by as much: |dx| + |dy| < 1/2 +- 2 reach. Both bounds are on the safe side; ties do not
// matter to them.

// A segment whose ends lie within `reach` of a and of b, in x and in y. Less than 3/8; 0: the ends
// are known.
struct LooseSegment {
  Segment segment;
  Fixed reach;
};

// Is the segment x-major (y-major) for every place of its ends?
bool surely_x_major(const LooseSegment& loose);
bool surely_y_major(const LooseSegment& loose);

// Within `bounds`, by diamonds as `left-bottom` has them: all fragments that the rule has for some
// place of the ends, and none but such as it has for every place. The same where the ends are
// known.
std::vector<PixelPosition> possible_pixels(const LooseSegment& loose, const PixelBounds& bounds);
std::vector<PixelPosition> certain_pixels(const LooseSegment& loose, const PixelBounds& bounds);

// False only where no place of the ends makes the segment meet the closed diamond of a pixel.
bool may_meet_diamond(const LooseSegment& loose, PixelPosition pixel);

}  // namespace edgecase
