// SPDX-License-Identifier: MIT
//
// CTRF, the Common Test Report Format (https://ctrf.io, specification 0.0.0), as JSON.
//
// The tests of reports/test_outcomes.h, with their suites from the renderer down. `passed` and
// `skipped` are what they are there, everything else is `failed`; `rawStatus` is the verdict, and
// `extra` has the standing and the fingerprint. The format requires times, and results hold none,
// so that the same results give the same bytes: `start`, `stop` and every `duration` are 0.
#pragma once

#include <iosfwd>

#include "results/results.h"

namespace edgecase {

// Writes the document in UTF-8, test by test. The caller checks the stream's state afterwards.
void write_ctrf(const Results& results, std::ostream& out);

}  // namespace edgecase
