// SPDX-License-Identifier: MIT
//
// Output traits: which alternatives of the rules for stencil test, depth test and masks a renderer
// follows, and how often all that was found draws whole scenes.
#pragma once

#include <span>
#include <string>

#include "profile/profile.h"
#include "profile/scene_drawing.h"

namespace edgecase {

// Of scenes of cells: the alternatives under which a pixel's triangles, everything else as found so
// far, leave the colour and the stencil value that it has.
Trait infer_output_rule(const std::string& rule, std::span<const DrawnScene> told,
                        const Choices& found);

// In how many scenes fragments, hits, colours and stencil values are those that the rules found
// yield: all of them, in every pixel.
Trait output_agreement(std::string id, std::span<const DrawnScene> told, const Choices& found);

}  // namespace edgecase
