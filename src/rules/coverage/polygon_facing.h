// SPDX-License-Identifier: MIT
//
// Front and back faces (GL 4.6 core, 14.6.1). The sign of a triangle's area in the window says
// which way it faces. The draw says which order of vertices is the front. Culling drops triangles
// by their facing. The stencil test has a state for each facing.
//
//   area = 1/2 sum of (x_i y_i+1 - x_i+1 y_i)    above 0: counter-clockwise, y up
//
// Only the sign counts, and it is exact. A triangle of hardly any area still faces one way.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "exact/homogeneous.h"
#include "model/scene.h"
#include "rules/rule.h"

namespace edgecase {

Rule polygon_facing_rule();  // polygon.facing

enum class FacingMethod {
  as_set,
  reversed,    // y is assumed to run downwards
  always_ccw,  // the draw's front face is ignored
  not_culled,  // nothing is dropped
};
template <>
inline constexpr auto kNames<FacingMethod> = std::to_array<TabledAlternative<FacingMethod>>(
    {{FacingMethod::as_set, "as-set", Openness::mandated,
      "a polygon faces the front if its winding in the window is the one that the draw sets"},
     {FacingMethod::reversed, "reversed", Openness::illegal,
      "y is taken to run downward, which exchanges front and back"},
     {FacingMethod::always_ccw, "always-ccw", Openness::illegal,
      "counter-clockwise polygons face the front, whatever the draw sets"},
     {FacingMethod::not_culled, "not-culled", Openness::illegal, "no polygon is dropped"}});

// Points and lines face the front.
bool is_front_facing(const ScenePrimitive& primitive,
                     const std::array<HomogeneousPoint, 3>& positions, FacingMethod method);

// True if the primitive is dropped before it is rasterized. `positions`: its vertices, snapped.
bool is_culled(const ScenePrimitive& primitive, const std::array<HomogeneousPoint, 3>& positions,
               FacingMethod method);

}  // namespace edgecase
