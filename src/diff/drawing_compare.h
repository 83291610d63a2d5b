// SPDX-License-Identifier: MIT
//
// Compares one drawing: a scene that is not supersampled, or one pass of a supersampled scene. Used
// by compare(); see diff/compare.h for the arguments.
#pragma once

#include "diff/compare.h"
#include "rules/choices.h"
#include "rules/rule.h"

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

}  // namespace edgecase
