// SPDX-License-Identifier: MIT
//
// Which hypotheses about its renderer explain an answer (rules/hypotheses.h).
#pragma once

#include <vector>

#include "diff/drawing_compare.h"
#include "model/result.h"

namespace edgecase {

// The numbers of all hypotheses that explain what an answer covers or, where it covers what it
// should, its colours, and the mark of which of them was asked; ascending. Empty where neither
// differs, and for a supersampled scene.
std::vector<NumberRun> explaining_hypotheses(const Drawing& drawing);

}  // namespace edgecase
