// SPDX-License-Identifier: MIT
//
// The HTML report as files: the page, scripts with the details that do not fit, and texts that are
// not in the results.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/html.h"
#include "results/comparison.h"
#include "results/generations.h"
#include "results/results.h"

namespace edgecase {

// The page that `path` is to have, or standard output for "-", and if `all_details` the scripts
// that lie beside it.
std::vector<HtmlFile> make_html_report(const Results& results,
                                       const std::optional<Comparison>& since,
                                       const Generations& generations, const std::string& path,
                                       bool all_details);

// Writes them. Removes scripts that only an earlier page of the same name needed. Prints an error
// and returns false if a file cannot be written.
bool write_html_report(const std::vector<HtmlFile>& files, const std::string& path);

}  // namespace edgecase
