// SPDX-License-Identifier: MIT
//
// What ends up in the depth buffer (GL 4.6 core, 2.3.5.2 and 13.8.1).
//
// A depth of 0 to 1 becomes an integer of 16 or 24 bits, depth times 2^bits - 1, or a float32
// number, which may lie beyond 0 to 1 by as much as the depth was rounded. A pixel without a
// fragment keeps the clear value, 1.
#pragma once

#include "exact/interval.h"
#include "model/scene.h"
#include "rules/rule.h"

namespace edgecase {

Rule depth_buffer_rule();  // framebuffer.depth

// Bits of an unsigned format; 0 for depth32f and none.
int bits_of(DepthFormat format);

// The stored value nearest to a depth: of two equally near the one with the even integer. For the
// unsigned formats depths beyond 0 to 1 are clamped first. NaN is stored as 0.
double to_depth(double depth, DepthFormat format);

// Stored values that the conversion of any number in `depth` may yield: either neighbour.
Interval depth_permitted(Interval depth, DepthFormat format);

}  // namespace edgecase
