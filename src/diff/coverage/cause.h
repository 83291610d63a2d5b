// SPDX-License-Identifier: MIT
//
// Cause: which catalogued alternatives would have drawn what the renderer drew.
#pragma once

#include <string>
#include <vector>

#include "diff/coverage/coverage_diff.h"
#include "model/scene.h"
#include "model/verdict.h"
#include "rules/choices.h"

namespace edgecase {

// The cause of a line that lacks one fragment between others (ruling 3); no alternative does so.
inline constexpr AlternativeId kInteriorGap{RuleId::line_interior_gap};

// One primitive, the policy's choices and, if known, the choices that the renderer is measured to
// follow.
struct CauseQuestion {
  const ScenePrimitive& primitive;
  const Target& target;
  const RuleChoices& chosen;
  const RuleChoices* profile = nullptr;
  SamplePositions reported{};  // sample positions as the renderer reports them
  // Ask the profile's alternatives before others: the same causes, found sooner.
  bool likely_first = true;
  // More samples differ than are reported in full: two alternatives are asked together only if the
  // profile has them.
  bool is_gross = false;
};

// The smallest sets of alternatives under which the primitive covers exactly `coverage.drawn`, in
// the order of their rules' ids: all sets of one alternative besides the policy's choices; if there
// are none, sets of two; if there are none, the profile's differences from the policy with zero,
// one or two more alternatives. If no such set conforms, larger sets of alternatives that the
// specification leaves open are added if they fit: pairs, and the profile's differences. Sets that
// lie wholly in the profile come alone, since the renderer follows them elsewhere. A line without
// any set, whose only fault is one fragment missing between others, gets kInteriorGap. Empty:
// nothing in the catalogue explains it.
std::vector<Cause> find_causes(const CauseQuestion& question, const PrimitiveCoverage& coverage);

// The pairs of samples that, exchanged, draw the primitive as `coverage.drawn` has it: "0 and 1, or
// 2 and 3".
std::string swapped_pairs(const CauseQuestion& question, const PrimitiveCoverage& coverage);

// The profile's differences from the policy, without those that can be left out, if they draw the
// primitive as `coverage.drawn` has it; else empty.
Cause cause_in_profile(const CauseQuestion& question, const PrimitiveCoverage& coverage);

}  // namespace edgecase
