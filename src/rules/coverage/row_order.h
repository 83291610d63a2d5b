// SPDX-License-Identifier: MIT
//
// Row order: the direction in which a rasterizer counts the rows of its target.
//
// Window coordinates have y up. The first row of a window surface in memory is the top one. A
// rasterizer that works in the order of memory therefore sees window surfaces upside down. Its ties
// and its rounding are upside down too. What it rounds up is rounded down in window coordinates.
// The edges that it takes for top edges are bottom edges.
#pragma once

#include <string>
#include <string_view>

#include "exact/fixed.h"
#include "exact/homogeneous.h"
#include "exact/pixel.h"
#include "rules/rule.h"

namespace edgecase {

enum class RowOrder { bottom_up, top_down };

// "bottom-up", "top-down".
const char* name_of(RowOrder order);
// False when there is none of that name.
bool parse_name(std::string_view name, RowOrder& order);

// The catalogue entry; `id` is "point.row-order", "line.row-order" or "triangle.row-order".
Rule row_order_rule(const std::string& id);

// A point and a rectangle of pixels upside down in a target of `height` rows.
Point turned_over(Point point, int height);
HomogeneousPoint turned_over(const HomogeneousPoint& point, int height);
PixelBounds turned_over(const PixelBounds& bounds, int height);

}  // namespace edgecase
