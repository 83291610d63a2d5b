// SPDX-License-Identifier: MIT
//
// The HTML report as files: the page, scripts with the details that do not fit, and texts that are
// not in the results.
#pragma once

#include <optional>
#include <string>

#include "results/comparison.h"
#include "results/generations.h"
#include "results/results.h"

namespace edgecase {

// Writes the page to `path`, or to standard output for "-"; if `all_details`, also the scripts
// beside it. Removes scripts that only an earlier page of the same name needed. Prints an error and
// returns false if a file cannot be written.
bool write_html_report(const Results& results, const std::optional<Comparison>& since,
                       const Generations& generations, const std::string& path, bool all_details);

}  // namespace edgecase
