// SPDX-License-Identifier: MIT
//
// Lines of a results file that are about cases (results/results_json.h).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "results/results.h"

namespace edgecase {

// Appends what a case shares with others, as a JSON object: the head of this number.
void append_head(const CaseResults& one, std::size_t number, std::string& text);

// Appends the case as a JSON object. `renderers` are those of its results, in that order.
void append_case(const CaseResults& one, std::size_t head,
                 const std::vector<RendererInfo>& renderers, std::string& text);

// Is there anything to look at? Where every renderer agrees, as expected, its line in a list says
// it all.
bool has_details(const CaseResults& one);

// Of a rendering without a difference.
PixelCounts counts_of_agreement(int width, int height);

}  // namespace edgecase
