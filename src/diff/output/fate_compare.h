// SPDX-License-Identifier: MIT
//
// Scenes with fragment operations: every pixel and sample must hold, in all planes at once, what
// the renderer's own fragments make of it in some way that the specification permits (rulings 10,
// 18, 33, 37, 39 and 40). Colour, depth, stencil and how many fragments passed are judged together:
// a depth test that may have gone either way must have gone one way for all of them.
#pragma once

#include "diff/values/sample_writers.h"
#include "diff/values/value_diff.h"

namespace edgecase {

// Appends disagreements and aggregates to `result`. Planes that the renderer does not tell are left
// out.
void compare_fates(const ValueContext& context, const Rendering& rendered, Result& result);

// inferred_samples of diff/samples/sample_values.h for such scenes.
SamplePlanes fated_samples(const ValueContext& context, const Rendering& rendered, AlphaEnds ends);

}  // namespace edgecase
