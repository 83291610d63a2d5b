// SPDX-License-Identifier: MIT
//
// The comparison of two results files as Markdown, for a terminal, a pull request or release notes.
#pragma once

#include <string>

#include "results/comparison.h"

namespace edgecase {

// What differs beside the cases, then for each renderer how many cases changed in which way, by
// which rule and cause, and which, folded: at most 10 clusters and 10 cases of each change, and how
// many more there are. At most 64,000 bytes, so that a pull request's comment holds it. Texts from
// files and renderers stand as code, on one line.
std::string comparison_markdown(const Comparison& comparison);

}  // namespace edgecase
