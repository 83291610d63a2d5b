// SPDX-License-Identifier: MIT
//
// The terminal's summary: one line that says how the run ended, what nobody expected by cause
// (reports/unexpected_summary.h), what is wrong with the suite, then how many cases got which
// verdict from which renderer, and the causes of all differences (reports/cluster_summary.h).
#pragma once

#include <iosfwd>
#include <optional>

#include "results/comparison.h"
#include "results/results.h"

namespace edgecase {

// `color`: with ANSI escapes. `seconds`: what the run took, where that is known. Of each list at
// most 20 entries are written and then "and N more". Of no cases there is no table. Text from files
// and renderers is written on one line with its control characters made visible, so that no title
// can steer the terminal.
void write_summary(const Results& results, bool color, std::ostream& out,
                   std::optional<double> seconds = {});

// What changed since earlier results: for each renderer how many cases, and the ten largest groups
// by kind of change, rule and cause.
void write_changes(const Comparison& comparison, bool color, std::ostream& out);

}  // namespace edgecase
