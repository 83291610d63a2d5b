// SPDX-License-Identifier: MIT
//
// JUnit XML, for continuous integration.
//
// One `testsuite` per renderer and in it one `testcase` per case, with the renderer and the id's
// folders as class; reports/test_outcomes.h says what fails, and what else is a suite. What a
// test that passed has to tell is its `system-out`. No times are
// written: the same results give the same bytes.
#pragma once

#include <iosfwd>

#include "results/durations.h"
#include "results/results.h"

namespace edgecase {

// Writes the document in UTF-8; of 20,000 tests it takes less than 30 MB. The caller checks the
// stream's state afterwards.
// `durations` may be empty: the same results then give the same bytes.
void write_junit(const Results& results, const Durations& durations, std::ostream& out);

}  // namespace edgecase
