// SPDX-License-Identifier: MIT
//
// Points of size 1 (GL 4.6 core, 14.4).
//
// A point produces a fragment for each pixel whose centre lies inside a square of side 1 round the
// vertex, so exactly one, unless a centre lies on the square's boundary: the specification does not
// say whom a boundary belongs to. The older text of OpenGL does, for points without antialiasing:
// the pixel at (floor x, floor y). That is `right-top` here: a centre on the right or top side is
// owned, one on the left or bottom side is not.
#pragma once

#include "rules/coverage/explain.h"
#include "rules/coverage/tie_rule.h"
#include "rules/rule.h"

namespace edgecase {

Rule point_ownership_rule();

// Does a point of size 1 at `vertex` produce a fragment at pixel (x, y)?
bool point_covers(Point vertex, int x, int y, const TieRule& ties);

// Why, in a sentence with numbers.
Explanation explain_point(Point vertex, int x, int y, const TieRule& ties);

// May the specification's latitude hold the pixel covered, may it hold it uncovered? The vertex may
// move by less than 2^-bits in x and y, and boundaries are open.
bool point_possibly_covered(Point vertex, int x, int y, int bits);
bool point_possibly_uncovered(Point vertex, int x, int y, int bits);

}  // namespace edgecase
