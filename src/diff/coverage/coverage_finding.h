// SPDX-License-Identifier: MIT
//
// What is told of a sample that a primitive should cover and does not, covers and should not, or
// covers twice.
#pragma once

#include <string>
#include <vector>

#include "diff/coverage/coverage_diff.h"
#include "model/scene.h"
#include "model/verdict.h"

namespace edgecase {

// `sample`: where it lies in the window. Its legality, cause and explanation are left open.
Disagreement at_sample(const ScenePrimitive& primitive, const CoverageDifference& difference,
                       Point sample, const Target& target);

// The same of one that is covered more than once, complete (ruling 7).
Disagreement duplicate(const ScenePrimitive& primitive, const CoverageDifference& difference,
                       Point sample, const Target& target);

// Adds names of snaps to others, the whole in catalogue order.
void merge_snaps(const std::vector<std::string>& more, std::vector<std::string>& names);

}  // namespace edgecase
