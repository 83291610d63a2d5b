// SPDX-License-Identifier: MIT
//
// Compares a supersampled scene: each pass as a scene of its own, then the image of all passes with
// the renderer's own passes. See diff/compare.h for the arguments.
#pragma once

#include "diff/drawing_compare.h"

namespace edgecase {

// Like compare_drawing, for a supersampled scene, with the image of all passes. Disagreements and
// evidence name their pass, and their figures are moved back by its shift to fit the scene's own
// figure. Values are counted over all passes.
Result compare_passes(const Drawing& drawing, const AlternativeSet& refuted);

}  // namespace edgecase
