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

// Coverage alone where it is known of all values that they are correct
// (diff/values/equal_values.h).
enum class Compared { all, coverage };

// Disagreements are not sorted, and values tell of attributes, too, of which nothing differs.
// `refuted`: which alternatives are refuted already, as Result::refuted. They stay so, and are not
// tried again.
Result compare_drawing(const Drawing& drawing, const AlternativeSet& refuted,
                       Compared compared = Compared::all);

}  // namespace edgecase
