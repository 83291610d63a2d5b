// SPDX-License-Identifier: MIT
//
// Blend traits: what a renderer stores of colours, plain ones and blended ones.
//
// Cells tell what is blended: the colour of a triangle with the code that the first draw put there.
#pragma once

#include <span>
#include <vector>

#include "profile/output/code_rounding.h"
#include "profile/output/output_profile.h"
#include "profile/profile.h"
#include "profile/scene_drawing.h"
#include "rules/output/blending.h"

namespace edgecase {

// Codes of plain colours.
void add_plain_colors(std::span<const DrawnScene> told, CodeTally& tally);

// blend.equation: the alternatives under which what is stored is permitted (ruling 37).
Trait infer_blend_method(std::span<const DrawnScene> told);

// blend.rounding: the alternatives that yield what is stored, value by value.
Trait infer_blend_rounding(std::span<const DrawnScene> told, BlendMethod method);

// How far from an alternative blended values are.
std::vector<BlendResidual> blend_residuals(std::span<const DrawnScene> told,
                                           const BlendChoice& choice);

}  // namespace edgecase
