// SPDX-License-Identifier: MIT
//
// Explanation: why a primitive draws a pixel under a choice of rules, or does not.
#pragma once

#include "exact/pixel.h"
#include "model/scene.h"
#include "rules/choices.h"
#include "rules/coverage/explain.h"

namespace edgecase {

// A sentence by the rule that decides, with numbers and its figure.
Explanation explain(const ScenePrimitive& primitive, PixelPosition pixel,
                    const CoverageChoice& choice);

}  // namespace edgecase
