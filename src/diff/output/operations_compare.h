// SPDX-License-Identifier: MIT
//
// Scenes with fragment operations: every pixel and sample must hold, in all planes at once, a
// permitted result of the renderer's own fragments (rulings 10, 18, 33, 37, 39 and 40). Colour,
// depth, stencil and the number of passed fragments are judged together: a depth test that may have
// gone either way must have gone the same way for all of them.
#pragma once

#include "diff/values/pixel_truth.h"
#include "diff/values/value_diff.h"

namespace edgecase {

// Appends disagreements and aggregates to `result`. Planes that the renderer does not report are
// left out.
void compare_operations(const ValueContext& context, const Rendering& rendered, Result& result);

// inferred_samples of diff/samples/sample_values.h for scenes with fragment operations.
SamplePlanes samples_by_operations(const ValueContext& context, const Rendering& rendered,
                                   AlphaEnds ends);

}  // namespace edgecase
