// SPDX-License-Identifier: MIT
//
// Why a triangle that reaches out of the clip volume covers a sample, or does not.
#pragma once

#include "model/scene.h"
#include "rules/coverage/explain.h"
#include "rules/coverage/tie_rule.h"

namespace edgecase {

// In the words of the homogeneous method, which decides without vertices of its own. With the
// outline of what is seen of the triangle.
Explanation explain_clipped_triangle(const ScenePrimitive& triangle, Point sample,
                                     const TieRule& ties);

// Of a point: its vertex lies outside, and nothing of it is drawn.
Explanation explain_clipped_point(const ScenePrimitive& point, Point sample);

// The outline of what is seen of a clipped triangle through its viewport; no mark of a point.
Figure figure_of_seen(const ScenePrimitive& primitive);

}  // namespace edgecase
