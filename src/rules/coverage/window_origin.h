// SPDX-License-Identifier: MIT
//
// The window's origin is its lower left corner, and y runs upward.
//
// The specification says so in three places. The viewport is given by its lower left corner (GL 4.6
// core, 13.8.1). A fragment is located by the lower left corner of its grid square (14,
// introduction). Pixels are read back from the lowest row upward (18.2.2).
//
// Most image formats and most windowing systems store the top row first. A rasterizer that was
// written for them may forget to flip its picture, or flip it twice. Such a picture has a single
// fault: its rows stand in reverse order. Reporting every sample as one on the wrong side of an
// edge would hide that fault.
//
// The direction of rows while ties are decided is a separate question, which is open: see
// row_order.h.
#pragma once

#include "rules/rule.h"

namespace edgecase {

// The rule's id, and the cause of what disagrees because of it.
inline constexpr RuleId kWindowOrigin = RuleId::window_origin;
inline constexpr int kRulingOnOrigin = 43;

Rule window_origin_rule();

}  // namespace edgecase
