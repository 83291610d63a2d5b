// SPDX-License-Identifier: MIT
//
// The terminal's summary: how many cases got which verdict from which renderer, then what no
// alternative accounts for, the causes of the rest (reports/cluster_summary.h), and what nobody
// expected, each with its first explanation.
#pragma once

#include <iosfwd>

#include "results/results.h"

namespace edgecase {

// Writes the table verdict x renderer, the clusters, broken case files, unmet hand-drawn
// expectations and the unexpected results, at most 20 of each and then "and N more". `color`: with
// ANSI escapes. Text from files and renderers is written on one line with its control characters
// made visible, so that no title can steer the terminal.
void write_summary(const Results& results, bool color, std::ostream& out);

}  // namespace edgecase
