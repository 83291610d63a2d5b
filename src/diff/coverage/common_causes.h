// SPDX-License-Identifier: MIT
//
// Common causes: a renderer draws all primitives of a draw in one way. For a broken ruling, an
// alternative that draws one primitive as it was drawn but not the others is no cause: a hole
// between two triangles does not come from a tie order that each of them could follow alone.
#pragma once

#include <span>
#include <vector>

#include "diff/coverage/cause.h"
#include "diff/coverage/coverage_diff.h"
#include "model/scene.h"
#include "model/verdict.h"

namespace edgecase {

// One primitive and what was drawn of it.
struct DrawnPrimitive {
  const ScenePrimitive* primitive = nullptr;
  const PrimitiveCoverage* coverage = nullptr;
};

// Those of `causes`, which draw question.primitive as in `own`, under which the other primitives,
// of the same kind, are also drawn as they were. One more alternative may help if it changes
// nothing of the first primitive. Causes that are no alternatives of coverage stay.
std::vector<Cause> common_causes(const CauseQuestion& question, const PrimitiveCoverage& own,
                                 const std::vector<Cause>& causes,
                                 std::span<const DrawnPrimitive> others);

}  // namespace edgecase
