// SPDX-License-Identifier: MIT
//
// What is drawn at one go, a scene that is not supersampled or a pass, compared. For compare() and
// for the passes of a supersampled scene; see diff/compare.h for what is given.
#pragma once

#include <string>

#include "diff/compare.h"

namespace edgecase {

// All must outlive it.
struct Drawing {
  const Scene& scene;
  const ResolvedPolicy& policy;
  const Rendering& exact;
  const Rendering& rendered;
  const RendererFacts& facts;
};

// Coverage alone where it is known of all values that they are correct (has_exact_values).
enum class Compared { all, coverage };

// Disagreements are not sorted, and values tell of attributes, too, of which nothing differs.
// `refuted`: which alternatives are refuted already, as Result::refuted. They stay so, and are not
// tried again.
Result compare_drawing(const Drawing& drawing, const AlternativeSet& refuted,
                       Compared compared = Compared::all);

// As compare_drawing, of a supersampled scene: each pass as a scene of its own, then the image of
// all of them against the renderer's own passes. A Result over all passes. Disagreements and
// evidence tell which pass they belong to, and figures are moved back from it, so that they lie
// upon the scene's own. Values are counted over all passes.
Result compare_passes(const Drawing& drawing, const AlternativeSet& refuted);

// The image of a supersampled scene (ruling 36): each number of it is the weighted mean of what the
// renderer's own passes show, and each pixel that number in 8 bits (ruling 10). A renderer that
// draws all passes rightly and accumulates them wrongly is caught here, and one whose passes are
// wrong is not blamed a second time. Appends disagreements and aggregates to `result`.
void compare_accumulated(const Drawing& drawing, Result& result);

}  // namespace edgecase
