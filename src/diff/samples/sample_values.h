// SPDX-License-Identifier: MIT
//
// Multisampled targets: the contents of their samples, inferred if a renderer does not report them,
// how often the shader ran, and the target as a whole. Each compare_ function appends disagreements
// and aggregates to `result`.
#pragma once

#include <span>

#include "diff/values/pixel_truth.h"
#include "diff/values/value_diff.h"
#include "rules/all_rules.h"

namespace edgecase {

// The samples that the renderer reports; it must have reported them.
SamplePlanes reported_samples(const Rendering& rendered);

// The samples that the renderer's own fragments, and its hits if it reports them, must have made:
// each has the colour of the fragment that wrote it last, or the clear colour.
SamplePlanes inferred_samples(const ValueContext& context, const Rendering& rendered,
                              AlphaEnds ends);

// How often the shader ran for the pixels of multisampled draws.
ShadingRate followed_rate(const ValueContext& context, const Rendering& rendered);
void compare_invocations(const ValueContext& context, const Rendering& rendered, Result& result);

// Compares a multisampled target as a whole: resolved pixels with the renderer's own samples, and
// the count of writes to each sample with the renderer's own fragments.
void compare_resolved_pixels(const ValueContext& context, const Rendering& rendered,
                             Result& result);
void compare_sample_hits(const ValueContext& context, const Rendering& rendered, Result& result);

// The first alternative besides the chosen one that yields everything; no cause if none does.
template <class Choice, class Yields>
Cause cause_among(std::span<const Choice> all, Choice chosen, RuleId rule, const Yields& yields) {
  for (const Choice choice : all)
    if (choice != chosen && yields(choice)) return alternative_id(rule, name_of(choice));
  return {};
}

}  // namespace edgecase
