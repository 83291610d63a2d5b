// SPDX-License-Identifier: MIT
//
// Cases as GoogleTest tests: one for each case and renderer, and one for each case file that cannot
// be loaded.
//
// Nothing is drawn when tests are registered or listed. When GoogleTest begins to run, its filter
// and shard have selected the tests. Their cases are then drawn and judged as one run of `edgecase
// run`: each renderer is started once per thread, and lines are judged as in that run. The tests
// then report the results, so a test takes no time of its own.
#pragma once

#include <string>
#include <vector>

#include "tools/edgecase/suite_run.h"

namespace edgecase {

// The cases and options of the tests.
struct CaseTests {
  Suite suite;
  RunOptions run;
  std::string progress;  // as SuiteRunOptions have it
};

// The prefix of the suites of each renderer's tests; empty if there is only one renderer.
std::vector<std::string> suite_prefixes(const std::vector<std::string>& renderers);

// Registers the tests. A test passes if its answer is as expected or, with a message, a known
// fault; it is skipped if the renderer does not support the scene; otherwise it fails with the
// explanation. The id is the property "id" of GoogleTest's XML, and the failure is at the case
// file.
void register_case_tests(CaseTests tests);

}  // namespace edgecase
