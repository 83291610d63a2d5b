// SPDX-License-Identifier: MIT
//
// Triangles by scan conversion in single precision.
//
// Before edge functions, software rasterizers walked the rows: on each, the two edges that it
// crosses are evaluated, and the pixels between them are drawn. Mesa's softpipe still does. In
// single precision an edge has a slope that is rounded once and a start that is rounded twice, the
// long edge starts anew where the third vertex lies, and two triangles that share an edge from
// different vertices need not agree where it runs: samples on it are hit twice or not at all.
#pragma once

#include <vector>

#include "exact/pixel.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {

// The pixels within `bounds` that are drawn, row by row. Rows are walked upward; `x` and `y` of the
// vertices must be exact in single precision.
std::vector<PixelPosition> scanned_triangle_pixels(const Triangle& triangle,
                                                   const PixelBounds& bounds);

}  // namespace edgecase
