// SPDX-License-Identifier: MIT
//
// The comparison of two results files as Markdown, for a terminal, a pull request or release notes.
#pragma once

#include <string>

#include "results/comparison.h"

namespace edgecase {

// First the differences other than those of cases. Then, for each renderer, the number of cases for
// each kind of change; and, folded, their clusters by rule and cause and the cases themselves: at
// most 10 of each, and the numbers of the others. At most 64,000 bytes, which fit into the comment
// of a pull request. Texts from files and renderers are written as code, on one line.
std::string comparison_markdown(const Comparison& comparison);

}  // namespace edgecase
