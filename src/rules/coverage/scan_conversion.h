// SPDX-License-Identifier: MIT
//
// Scan conversion in single precision.
//
// Before edge functions, software rasterizers walked the rows: on each, they evaluated the two
// edges that the row crosses and drew the pixels between them. Mesa's softpipe still does. In
// single precision, an edge has a slope rounded once and a start rounded twice, the long edge
// starts again at the third vertex, and two triangles that share an edge from different vertices
// need not agree on its position: samples on it are hit twice or not at all.
#pragma once

#include <vector>

#include "exact/fixed.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {

// The pixels within `bounds` that are drawn, row by row. Rows are walked upward; the vertices' `x`
// and `y` must be exact in single precision.
std::vector<PixelPosition> scanned_triangle_pixels(const Triangle& triangle,
                                                   const PixelBounds& bounds);

}  // namespace edgecase
