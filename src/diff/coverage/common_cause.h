// SPDX-License-Identifier: MIT
//
// Common causes: a renderer has one way of drawing for all primitives of a draw. Of what breaks a
// ruling, an alternative that draws one primitive as it was drawn, and others not, is no cause: a
// hole between two triangles is not made by a tie order that each of them could follow alone.
#pragma once

#include <span>
#include <vector>

#include "diff/coverage/cause.h"

namespace edgecase {

// One primitive and what was drawn of it.
struct DrawnPrimitive {
  const ScenePrimitive* primitive = nullptr;
  const PrimitiveCoverage* coverage = nullptr;
};

// Those of `causes`, which draw question.primitive as `own` has it, under which the other
// primitives, of the same kind, are drawn as they were, too; a further alternative beside the cause
// may help where it changes nothing of the first. Causes that are no alternatives of coverage stay.
std::vector<Cause> common_causes(const CauseQuestion& question, const PrimitiveCoverage& own,
                                 const std::vector<Cause>& causes,
                                 std::span<const DrawnPrimitive> others);

}  // namespace edgecase
