// SPDX-License-Identifier: MIT
//
// JUnit XML, for continuous integration.
//
// There is one `testsuite` per renderer with one `testcase` per case, whose class is the renderer
// and the id's folders; reports/test_outcomes.h defines failures and further suites. The message of
// a passed test is its `system-out`. A test that is not as expected has a property "group": the
// cause of its worst difference, or its rule and kind, as the terminal and the report title them. A
// suite has a property "portrait" for each sentence that all answers of its renderer allow.
#pragma once

#include <iosfwd>

#include "results/durations.h"
#include "results/results.h"

namespace edgecase {

// Writes the document in UTF-8: less than 30 MB for 20,000 tests. Without `durations` it has no
// times, and the same results give the same bytes. The caller checks the stream's state afterwards.
void write_junit(const Results& results, const Durations& durations, std::ostream& out);

}  // namespace edgecase
