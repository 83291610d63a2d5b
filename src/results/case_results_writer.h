// SPDX-License-Identifier: MIT
//
// One case of a results file (results/results_json.h).
#pragma once

#include <string>
#include <vector>

#include "results/results.h"

namespace edgecase {

// Appends the case as a JSON object to `text`. `renderers` are those of its results, in that order.
void append_case(const CaseResults& one, const std::vector<RendererInfo>& renderers,
                 std::string& text);

}  // namespace edgecase
