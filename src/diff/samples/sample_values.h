// SPDX-License-Identifier: MIT
//
// Multisampled targets: what their samples hold, where a renderer need not say it, how often the
// shader ran, and what the target holds as a whole. Each compare_ appends disagreements and
// aggregates to `result`.
#pragma once

#include <span>

#include "diff/values/sample_writers.h"
#include "rules/all_rules.h"

namespace edgecase {

// As the renderer tells them; it must have done so.
SamplePlanes told_samples(const Rendering& rendered);

// As the renderer's own fragments, and its hits if it tells them, put them there: each sample holds
// the colour of the fragment by which it was written last, or the clear colour.
SamplePlanes inferred_samples(const ValueContext& context, const Rendering& rendered,
                              AlphaEnds ends);

// How often the shader ran for the pixels of multisampled draws.
ShadingRate followed_rate(const ValueContext& context, const Rendering& rendered);
void compare_invocations(const ValueContext& context, const Rendering& rendered, Result& result);

// What a multisampled target holds as a whole: resolved pixels against the renderer's own samples,
// and how often it wrote each sample against its own fragments.
void compare_resolved_pixels(const ValueContext& context, const Rendering& rendered,
                             Result& result);
void compare_sample_hits(const ValueContext& context, const Rendering& rendered, Result& result);

// The first alternative beside the chosen one that yields all there is; no cause where none does.
template <class Choice, class Yields>
Cause cause_among(std::span<const Choice> all, Choice chosen, RuleId rule, const Yields& yields) {
  for (const Choice choice : all)
    if (choice != chosen && yields(choice)) return alternative_id(rule, name_of(choice));
  return {};
}

}  // namespace edgecase
