// SPDX-License-Identifier: MIT
//
// The last question before an answer agrees: is all that it stores what exact stores?
#pragma once

#include "model/rendering.h"
#include "model/result.h"

namespace edgecase {

// True if something was found that differs from exact.
bool has_differences(const Result& result);

// Appends an aggregate for each plane that both renderings have and that differs: pixels, samples,
// depths, stencils, hits and accumulated colours, of passes too. Only for a result
// without differences. Each value has been found permitted by then, such as that of a sample which
// alpha to coverage may have written or not; but it is not exact's, so the answer does not agree.
void find_differing_planes(const Rendering& exact, const Rendering& rendered, Result& result);

}  // namespace edgecase
