// SPDX-License-Identifier: MIT
//
// A supersampled scene compared: each pass as a scene of its own, then the image of all of them
// against the renderer's own passes (diff/samples/pass_values.h).
#pragma once

#include <string>

#include "diff/drawing_compare.h"

namespace edgecase {

// As compare_drawing, of a supersampled scene: a Result over all passes. Disagreements and evidence
// tell which pass they belong to, and figures are moved back from it, so that they lie upon the
// scene's own. Values are counted over all passes.
Result compare_passes(const Drawing& drawing, const AlternativeSet& refuted);

}  // namespace edgecase
