// SPDX-License-Identifier: MIT
//
// The run on one page of Markdown, for a job's page in CI or a comment: verdicts per renderer, what
// nobody expected, each with its first explanation and the command that tells more, and what the
// differences are about.
#pragma once

#include <iosfwd>

#include "results/results.h"

namespace edgecase {

// GitHub shows a job's summary of at most 1 MiB, and nothing of a longer one.
inline constexpr std::size_t kMostOfSummary = 1'000'000;  // bytes

// At most 50 of what is unexpected, 20 of every other kind and 10 clusters a renderer, and how many
// more there are; never more than kMostOfSummary bytes, whatever names and explanations hold: what
// does not fit is left out, and said to be. Texts from files and renderers stand as code. The
// caller checks the stream's state afterwards.
void write_markdown_summary(const Results& results, std::ostream& out);

}  // namespace edgecase
