// SPDX-License-Identifier: MIT
//
// The summary on the terminal: one line with the outcome of the run, unexpected results by cause
// (reports/unexpected_summary.h), faults of the suite, the number of cases by verdict for each
// renderer, and the causes of all differences (reports/cluster_summary.h).
#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>

#include "results/comparison.h"
#include "results/results.h"

namespace edgecase {

// What is to be said of the run that found the results.
struct RunCost {
  double seconds = 0;
  std::size_t as_before = 0;  // answers that an earlier run has compared (run/earlier_answers.h)
  std::string note = {};      // the second line: where they come from; empty: none
};

// `color`: with ANSI escapes. `cost`: if known. Of each list at most 20
// entries are written, then "and N more". Text from files and renderers is written on one line with
// control characters made visible, so that no title can control the terminal.
void write_summary(const Results& results, bool color, std::ostream& out,
                   std::optional<RunCost> cost = {});

// Changes since earlier results: for each renderer the number of cases, and the ten largest groups
// by kind of change, rule and cause.
void write_changes(const Comparison& comparison, bool color, std::ostream& out);

}  // namespace edgecase
