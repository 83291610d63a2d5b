// SPDX-License-Identifier: MIT
//
// Explanation: why a primitive covers a sample under a choice of rules, or does not.
#pragma once

#include "exact/pixel.h"
#include "model/scene.h"
#include "rules/choices.h"
#include "rules/coverage/explain.h"

namespace edgecase {

// A sentence by the rule that decides, with numbers and its figure. A line that is not multisampled
// draws the pixel of a sample that is its centre.
Explanation explain(const ScenePrimitive& primitive, Point sample, const Target& target,
                    const CoverageChoice& choice);

}  // namespace edgecase
