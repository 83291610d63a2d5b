// SPDX-License-Identifier: MIT
//
// How `run` and `merge` end: known faults applied, the summary printed, the files written, the exit
// code found. One path for both, so that what is merged from shards is what one run would write.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/summary.h"
#include "results/results.h"
#include "tools/edgecase/exit_code.h"
#include "tools/edgecase/output/report_files.h"

namespace edgecase {

// Of results to which known faults were applied. Where no case was selected nothing is written, so
// that what an earlier run wrote stays. `cost`: of the run, where it was one.
ExitCode deliver_results(const Results& results, const ReportFiles& files, const std::string& color,
                         std::optional<RunCost> cost = {});

}  // namespace edgecase
