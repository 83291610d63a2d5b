// SPDX-License-Identifier: MIT
//
// Row order: the direction in which a rasterizer counts the rows of its target.
//
// Window coordinates have y up. The first row of a window surface in memory is the top one. A
// rasterizer that works in the order of memory therefore sees window surfaces upside down. Its ties
// and its rounding are upside down too. What it rounds up is rounded down in window coordinates.
// The edges that it takes for top edges are bottom edges.
#pragma once

#include "exact/fixed.h"
#include "exact/homogeneous.h"
#include "exact/pixel.h"
#include "rules/alternative_table.h"
#include "rules/rule.h"

namespace edgecase {

enum class RowOrder { bottom_up, top_down };
template <>
inline constexpr auto kNames<RowOrder> = std::to_array<TabledAlternative<RowOrder>>(
    {{RowOrder::bottom_up, "bottom-up", Openness::open, "ties and rounding see y up"},
     {RowOrder::top_down, "top-down", Openness::open,
      "the target is seen upside down: ties, rounding and offsets see y down"}});

// The catalogue entry; `id` is "point.row-order", "line.row-order" or "triangle.row-order".
Rule row_order_rule(RuleId id);

// A point and a rectangle of pixels upside down in a target of `height` rows.
Point turned_over(Point point, int height);
HomogeneousPoint turned_over(const HomogeneousPoint& point, int height);
PixelBounds turned_over(const PixelBounds& bounds, int height);

}  // namespace edgecase
