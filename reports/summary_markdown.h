// SPDX-License-Identifier: MIT
//
// The run on one page of Markdown, for a job's page in CI or a comment: verdicts per renderer;
// unexpected results, each with its first explanation and the command for more; and the clusters of
// differences.
#pragma once

#include <iosfwd>

#include "results/results.h"

namespace edgecase {

// GitHub shows a job's summary only up to 1 MiB.
inline constexpr std::size_t kMostOfSummary = 1'000'000;  // bytes

// Writes at most 50 unexpected results, 20 entries of every other kind and 10 clusters a renderer,
// and the numbers of the others; never more than kMostOfSummary bytes: a note replaces what does
// not fit. Texts from files and renderers are written as code. The caller checks the stream's state
// afterwards.
void write_markdown_summary(const Results& results, std::ostream& out);

}  // namespace edgecase
