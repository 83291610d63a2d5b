// SPDX-License-Identifier: MIT
//
// Lines as parallelograms whose ends are tested: what Mesa's llvmpipe draws, its own approximation
// of the diamond-exit rule.
//
// The parallelogram has the segment in its middle, its ends run along the minor axis, and it is as
// high as the line is wide, rounded to an integer. Alone it would draw the pixels whose centres the
// segment passes along its major axis. So each end is asked, in single precision, whether the
// diamond-exit rule has its pixel drawn and whether the parallelogram has; where the two answers
// differ, the end is moved along the line to the border of its pixel. Then the ends are snapped,
// from the centre of pixel 0, to a grid of 1/256 pixel, ties away from zero, and what is inside is
// decided exactly: nothing where the ends have moved past each other.
//
// The tests are right but for some ties, for which of the diamond's sides a line crosses, and for
// wide lines, whose ends are tested where the segment lies and not where its lowest fragments do.
// Equal lengths count as x-major.
#pragma once

#include <vector>

#include "exact/pixel.h"
#include "rules/coverage/segment.h"
#include "rules/coverage/tie_rule.h"

namespace edgecase {

// The pixels within `bounds`, along the major axis; none of a segment without length. `width`:
// pixels, at least 1, already rounded. `ties` decides centres on the parallelogram's sides.
std::vector<PixelPosition> tested_ends_pixels(const Segment& segment, int width,
                                              const PixelBounds& bounds, const TieRule& ties);

}  // namespace edgecase
