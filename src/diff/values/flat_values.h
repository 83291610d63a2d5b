// SPDX-License-Identifier: MIT
//
// Flat attributes, and what OpenGL ES permits of values where OpenGL is stricter (rulings 8 and
// 46).
#pragma once

#include "diff/values/value_diff.h"
#include "exact/interval.h"
#include "model/rendering.h"
#include "model/scene.h"

namespace edgecase {

// A component of a flat attribute whose value at the provoking vertex is `value`. It is copied
// (ruling 8). OpenGL ES interpolates the floats of polygons even so, between three equal values,
// and precision may be lost (ES 3.2, 13.7.1).
Interval permitted_flat(const ValueContext& context, const ScenePrimitive& primitive, double value);

// Flat colours and texture coordinates (ruling 8): those of the provoking vertex, to the bit, or in
// OpenGL ES nearly so. `fragment`: of a flat draw, with a colour, or with its texture coordinates
// in the colour's place. Returns false, and adds a disagreement, if it shows another value.
bool compare_flat_color(const ValueContext& context, const Fragment& fragment, Result& result);

// True if values of the fragment's line may follow its major axis: in OpenGL ES, without
// multisampling (ES 3.2, 13.6.1 and 13.6.4). Elsewhere that is contested (ruling 46).
bool may_go_by_major_axis(const ValueContext& context, const Fragment& fragment);

}  // namespace edgecase
