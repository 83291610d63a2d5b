// SPDX-License-Identifier: MIT
//
// Cause: which catalogued alternatives would have drawn what the renderer drew.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "diff/coverage_diff.h"
#include "model/scene.h"
#include "rules/choices.h"

namespace edgecase {

// The cause of a line that lacks one fragment between others (ruling 3); no alternative draws so.
inline constexpr const char* kInteriorGap = "line.interior-gap";

// The smallest sets of at most two alternatives, beside what the policy chooses, under which the
// primitive covers exactly `drawn`: all sets of the smallest size, each as "rule=alternative" or
// two joined by " + ", in catalogue order. A line without any, whose only fault is one fragment
// missing between others, gets kInteriorGap. Empty: nothing catalogued explains it.
std::vector<std::string> find_causes(const ScenePrimitive& primitive, const Target& target,
                                     const CoverageChoice& chosen,
                                     const PrimitiveCoverage& coverage);

// Every single alternative of the coverage rules as a cause, in one fixed order.
std::span<const std::string> alternative_names();

// Evidence against alternatives: the renderer draws this primitive as exact does, so what would
// draw it otherwise is not what the renderer follows. Marks those in `refuted` (see
// Result::refuted).
void mark_refuted(const ScenePrimitive& primitive, const Target& target,
                  const CoverageChoice& chosen, const PrimitiveCoverage& coverage,
                  std::string& refuted);

// The alternatives of a cause: what stands between " + ".
std::vector<std::string> parts_of(const std::string& cause);

// Does the specification leave open every alternative that a cause names?
bool is_open_choice(const std::string& cause);

}  // namespace edgecase
