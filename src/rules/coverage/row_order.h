// SPDX-License-Identifier: MIT
//
// Row order: which way the rows of the target run for a rasterizer.
//
// Window coordinates have y up. A rasterizer that works in the order of memory sees window surfaces
// upside down, since their first row in memory is the top one, and with them every tie and every
// rounding: what it rounds up is rounded down, y up, and bottom edges are its top edges.
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
