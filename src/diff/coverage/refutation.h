// SPDX-License-Identifier: MIT
//
// Refutation: which catalogued alternatives a renderer cannot follow.
#pragma once

#include "diff/coverage/cause.h"

namespace edgecase {

// Evidence against alternatives: the renderer draws this primitive as exact does, so what would
// draw it otherwise is not what the renderer follows. Marks those in `refuted` (see
// Result::refuted).
void mark_refuted(const CauseQuestion& question, const PrimitiveCoverage& coverage,
                  AlternativeSet& refuted);

}  // namespace edgecase
