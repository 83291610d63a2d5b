// SPDX-License-Identifier: MIT
//
// The image of a supersampled scene (ruling 36): each number of it is the weighted mean of what the
// renderer's own passes show, and each pixel that number in 8 bits (ruling 10). A renderer that
// draws all passes rightly and accumulates them wrongly is caught here, and one whose passes are
// wrong is not blamed a second time.
#pragma once

#include "diff/drawing_compare.h"

namespace edgecase {

// Appends disagreements and aggregates to `result`.
void compare_accumulated(const Drawing& drawing, Result& result);

}  // namespace edgecase
