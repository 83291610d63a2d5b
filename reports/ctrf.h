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

#include "results/durations.h"
#include "results/results.h"

namespace edgecase {

// Writes the document in UTF-8, test by test. The caller checks the stream's state afterwards.
// `durations` may be empty: the same results then give the same bytes.
void write_ctrf(const Results& results, const Durations& durations, std::ostream& out);

}  // namespace edgecase
