// SPDX-License-Identifier: MIT
//
// CTRF, the Common Test Report Format (https://ctrf.io, specification 0.0.0), as JSON.
//
// The tests of reports/test_outcomes.h, with their suites from the renderer down. Tests that passed
// or were skipped there are `passed` or `skipped`, all others `failed`. `rawStatus` is the verdict,
// and `extra` has the standing and the fingerprint. The format requires `start` and `stop`, which
// are 0.
#pragma once

#include <iosfwd>

#include "results/durations.h"
#include "results/results.h"

namespace edgecase {

// Writes the document in UTF-8, test by test. Without `durations` every `duration` is 0, and the
// same results give the same bytes. The caller checks the stream's state afterwards.
void write_ctrf(const Results& results, const Durations& durations, std::ostream& out);

}  // namespace edgecase
