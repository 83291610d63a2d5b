// SPDX-License-Identifier: MIT
//
// Parallelograms whose ends are tested: the lines of Mesa's llvmpipe, its own approximation of the
// diamond-exit rule.
//
// The segment lies in the middle of the parallelogram, whose ends run along the minor axis and
// whose height is the line's width, rounded to an integer. By itself it would draw the pixels whose
// centres the segment passes along its major axis. So each end is tested, in single precision: does
// the diamond-exit rule draw its pixel, and does the parallelogram? If the two answers differ, the
// end is moved along the line to the border of its pixel. Then the ends are snapped, from the
// centre of pixel 0, to a grid of 1/256 pixel, ties away from zero, and the inside is decided
// exactly: nothing is inside if the ends have moved past each other.
//
// The tests are right except for some ties, for which side of the diamond a line crosses, and for
// wide lines, whose ends are tested at the segment and not at its lowest fragments. Equal lengths
// count as x-major.
#pragma once

#include <vector>

#include "exact/fixed.h"
#include "rules/coverage/segment.h"
#include "rules/coverage/tie_rule.h"

namespace edgecase {

// The pixels within `bounds`, along the major axis; none for a segment without length. `width`:
// pixels, at least 1, already rounded. `ties` decides centres on the parallelogram's sides.
std::vector<PixelPosition> tested_ends_pixels(const Segment& segment, int width,
                                              const PixelBounds& bounds, const TieRule& ties);

}  // namespace edgecase
