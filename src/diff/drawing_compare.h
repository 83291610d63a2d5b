// SPDX-License-Identifier: MIT
//
// Compares one drawing: a scene that is not supersampled, or one pass of a supersampled scene. Used
// by compare(); see diff/compare.h for the arguments.
#pragma once

#include <string>

#include "diff/compare.h"

namespace edgecase {

// Everything referred to must outlive it.
struct Drawing {
  const Scene& scene;
  const ResolvedPolicy& policy;
  const Rendering& exact;
  const Rendering& rendered;
  const RendererFacts& facts;
};

// `coverage`: only coverage, for answers whose values are known to be correct (has_exact_values).
enum class Compared { all, coverage };

// Disagreements are unsorted, and `values` includes attributes without a difference. `refuted`:
// alternatives that are refuted already (Result::refuted); they stay so and are not tried again.
Result compare_drawing(const Drawing& drawing, const AlternativeSet& refuted,
                       Compared compared = Compared::all);

// Like compare_drawing, for a supersampled scene: compares each pass as a scene of its own, then
// the image of all passes with the renderer's own passes. Disagreements and evidence name their
// pass, and their figures are moved back by its shift to fit the scene's own figure. Values are
// counted over all passes.
Result compare_passes(const Drawing& drawing, const AlternativeSet& refuted);

// Compares the image of a supersampled scene (ruling 36): each number must be the weighted mean of
// what the renderer's own passes show, and each pixel that number in 8 bits (ruling 10). This
// catches a renderer that draws all passes correctly and accumulates them wrongly, and does not
// blame one whose passes are wrong a second time. Appends disagreements and aggregates to `result`.
void compare_accumulated(const Drawing& drawing, Result& result);

}  // namespace edgecase
