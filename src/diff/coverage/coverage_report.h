// SPDX-License-Identifier: MIT
//
// The report of a sample on which two coverages differ: where it lies, and why it is covered or
// not.
#pragma once

#include <string>
#include <vector>

#include "diff/coverage/coverage_diff.h"
#include "exact/fixed.h"
#include "model/scene.h"
#include "model/verdict.h"
#include "rules/choices.h"
#include "rules/rule.h"

namespace edgecase {

// A sample that a primitive should cover and does not, or covers and should not. Legality and cause
// are left open.
DisagreementClass class_of(const ScenePrimitive& primitive, const CoverageDifference& difference,
                           const Target& target);

// A sample that is covered more than once (ruling 7).
DisagreementClass class_of_duplicate(const ScenePrimitive& primitive,
                                     const CoverageDifference& difference);

// Fills in what both have in full, but for explanation and figure. `sample`: its position in the
// window.
void describe_sample(const ScenePrimitive& primitive, const CoverageDifference& difference,
                     Point sample, const Target& target, Disagreement& d);
// Explains a sample that only one side covers, by exact's choice. `sample`: its position in the
// window under that choice.
void explain_difference(const ScenePrimitive& primitive, const CoverageDifference& difference,
                        Point sample, const Target& target, const CoverageChoice& choice,
                        Disagreement& d);
// Explains a sample that is covered more than once.
void explain_duplicate(const CoverageDifference& difference, Point sample, const Target& target,
                       Disagreement& d);

// Merges names of snaps into `names`, in catalogue order.
void merge_snaps(const std::vector<std::string>& more, std::vector<std::string>& names);

// Why a primitive covers a sample under a choice of rules, or does not: a sentence with numbers by
// the rule that decides, and its figure. For a line that is not multisampled, the sample is the
// centre of the pixel.
Explanation explain(const ScenePrimitive& primitive, Point sample, const Target& target,
                    const CoverageChoice& choice);

}  // namespace edgecase
