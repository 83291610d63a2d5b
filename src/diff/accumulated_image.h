// SPDX-License-Identifier: MIT
//
// Compares the image of a supersampled scene (ruling 36): each number must be the weighted mean of
// what the renderer's own passes show, and each pixel that number in 8 bits (ruling 10). This
// catches a renderer that draws all passes correctly and accumulates them wrongly, and does not
// blame one whose passes are wrong a second time.
#pragma once

#include "diff/drawing_compare.h"

namespace edgecase {

// Appends disagreements and aggregates to `result`.
void compare_accumulated(const Drawing& drawing, Result& result);

}  // namespace edgecase
