// SPDX-License-Identifier: MIT
//
// What OpenGL accepts as a line (GL 4.6 core, 14.5.1, the relaxed rules; rulings 1 and 2).
//
// The predicate of the diamond-exit rule lives in diamond_exit.h; here is how far another algorithm
// may stray from it, judged from a segment and the pixels that were drawn of it, and nothing else.
#pragma once

#include <span>
#include <string>

#include "rules/coverage/diamond_exit.h"

namespace edgecase {

// A broken clause of rulings 1 and 2, in words; empty when every clause holds. `drawn` are the
// pixels that a renderer produced of the segment inside the target, each as often as it came.
std::string broken_line_clause(const Segment& segment, std::span<const PixelPosition> drawn,
                               const PixelBounds& target);

}  // namespace edgecase
