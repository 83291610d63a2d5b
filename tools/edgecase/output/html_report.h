// SPDX-License-Identifier: MIT
//
// The HTML report as files: the page, what is too large for it, and what it tells beyond the
// results.
#pragma once

#include <optional>
#include <string>

#include "results/comparison.h"
#include "results/results.h"

namespace edgecase {

// Writes the page to `path`, "-" meaning standard output, and, where `all_details` are asked for,
// beside it the scripts that it needs; those that an earlier page of the same name needed and this
// one does not are removed. False, with the error printed, when a file cannot be written.
bool write_html_report(const Results& results, const std::optional<Comparison>& since,
                       const std::string& path, bool all_details);

}  // namespace edgecase
