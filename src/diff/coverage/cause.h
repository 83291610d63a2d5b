// SPDX-License-Identifier: MIT
//
// Cause: which catalogued alternatives would have drawn what the renderer drew.
#pragma once

#include <span>
#include <vector>

#include "diff/coverage/coverage_diff.h"
#include "model/cause.h"
#include "model/scene.h"
#include "rules/choices.h"

namespace edgecase {

// The cause of a line that lacks one fragment between others (ruling 3); no alternative draws so.
inline constexpr AlternativeId kInteriorGap{RuleId::line_interior_gap};

// One primitive, with what the policy chooses and, where it is known, what the renderer is measured
// to follow.
struct CauseQuestion {
  const ScenePrimitive& primitive;
  const Target& target;
  const RuleChoices& chosen;
  const RuleChoices* profile = nullptr;
  SamplePositions reported{};  // where the renderer says that samples lie
};

// The smallest sets of alternatives under which the primitive covers exactly `coverage.drawn`, in
// the order of their rules' ids: all sets of one alternative beside what the policy chooses;
// without any, of two; without any, what the profile differs in from the policy, with nothing, one
// or two more alternatives on top of it. Where none of these conforms as such, larger sets that do,
// all of whose alternatives the specification leaves open, come with them: of two, and what the
// profile differs in. Sets that the profile holds wholly come alone, since it is what the renderer
// does elsewhere. A line without any set, whose only fault is one fragment missing between others,
// gets kInteriorGap. Empty: nothing catalogued explains it.
std::vector<Cause> find_causes(const CauseQuestion& question, const PrimitiveCoverage& coverage);

// What the profile differs in from the policy, without what can be left out, where that draws the
// primitive as `coverage.drawn` has it; else nothing.
Cause cause_in_profile(const CauseQuestion& question, const PrimitiveCoverage& coverage);

// Common causes: a renderer has one way of drawing for all primitives of a draw. Of what breaks a
// ruling, an alternative that draws one primitive as it was drawn, and others not, is no cause: a
// hole between two triangles is not made by a tie order that each of them could follow alone.
//
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

// Evidence against alternatives: the renderer draws this primitive as exact does, so what would
// draw it otherwise is not what the renderer follows. Marks those in `refuted` (see
// Result::refuted).
void mark_refuted(const CauseQuestion& question, const PrimitiveCoverage& coverage,
                  AlternativeSet& refuted);

}  // namespace edgecase
