// SPDX-License-Identifier: MIT
//
// Evidence against alternatives: a renderer that draws a primitive as exact does follows no
// alternative that would draw it differently.
#pragma once

#include "diff/coverage/cause.h"
#include "diff/coverage/coverage_diff.h"
#include "model/verdict.h"

namespace edgecase {

// The renderer draws this primitive as exact does. Marks in `refuted` the alternatives that would
// draw it differently (see Result::refuted).
void mark_refuted(const CauseQuestion& question, const PrimitiveCoverage& coverage,
                  AlternativeSet& refuted);

}  // namespace edgecase
