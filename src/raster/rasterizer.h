// SPDX-License-Identifier: MIT
//
// The exact rasterizer, plain path: stages over the primitives of a scene, each decision taken by
// the predicate of its rule. It knows no OpenGL and compares nothing.
//
//   primitives_of -> snap -> coverage (rules/coverage) -> attributes (rules/values)
//     -> textures (rules/textures) -> pixels
#pragma once

#include <vector>

#include "exact/pixel.h"
#include "model/policy.h"
#include "model/rendering.h"
#include "model/scene.h"
#include "rules/choices.h"

namespace edgecase {

// The pixels to which a draw can write: the target's, within the scissor rectangle. May be empty.
PixelBounds drawable_bounds(const Draw& draw, const Target& target);

// The pixels of the target that one primitive covers under a choice of rules, sorted by row,
// column.
std::vector<PixelPosition> covered_pixels(const ScenePrimitive& primitive, const Target& target,
                                          const CoverageChoice& choice);

// The rendering that a policy's rules, applied without rounding, produce.
Rendering rasterize(const Scene& scene, const Policy& policy);

}  // namespace edgecase
