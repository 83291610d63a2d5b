// SPDX-License-Identifier: MIT
//
// The comparison of two results files as Markdown, for a terminal, a pull request or release notes.
#pragma once

#include <iosfwd>

#include "results/comparison.h"

namespace edgecase {

// What differs beside the cases, then for each renderer how many cases changed in which way, by
// which rule and cause, and which: at most 20 clusters and 20 cases of each change, and how many
// more there are. Texts from files and renderers stand as code, on one line.
void write_comparison(const Comparison& comparison, std::ostream& out);

}  // namespace edgecase
