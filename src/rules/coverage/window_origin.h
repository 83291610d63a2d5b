// SPDX-License-Identifier: MIT
//
// The window's origin: its lower left corner, from which y runs upward.
//
// The viewport is given by its lower left corner (GL 4.6 core, 13.8.1), a fragment is located by
// the lower left corner of its grid square (14, introduction), and rows are read back from the
// lowest (18.2.2). Most image formats and most windowing systems have the first row on top, and a
// rasterizer that was written for them forgets to turn its picture over, or does so twice. Nothing
// of that picture is wrong but where its rows stand, and telling every sample of it as a sample on
// the wrong side of an edge would hide that.
//
// Which way rows run while ties are decided is another matter, and open: see row_order.h.
#pragma once

#include "rules/rule.h"

namespace edgecase {

// The rule's id, and the cause of what disagrees because of it.
inline constexpr const char* kWindowOrigin = "window.origin";
inline constexpr int kRulingOnOrigin = 43;

Rule window_origin_rule();

}  // namespace edgecase
