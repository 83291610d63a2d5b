// SPDX-License-Identifier: MIT
//
// Cases as GoogleTest tests: one a case and renderer, and one a case file that cannot be loaded.
//
// Nothing is drawn when tests are registered or listed. When GoogleTest begins to run, it has
// decided by its filter and shard which tests it runs, and these cases are drawn and judged as one
// run of `edgecase run`: each renderer is started once a thread, and lines are read as that run
// would read them. The tests then say what came of it. So a test takes no time of its own.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tools/edgecase/suite_run.h"

namespace edgecase {

// What is to be run.
struct CaseTests {
  Suite suite;
  Policy policy;
  std::map<std::string, Policy> profiles;
  SuiteRunOptions run;  // its renderers are named
  JudgedRun judged;     // without an earlier run
};

// What stands before the suites of each renderer's tests: nothing where there is but one.
std::vector<std::string> suite_prefixes(const std::vector<std::string>& renderers);

// Registers the tests. A test passes if its answer is as expected or a known fault, which it says;
// is skipped where the renderer does not support the scene; and fails with the explanation
// otherwise. The id is the property "id" of GoogleTest's XML, and the failure is at the case file.
void register_case_tests(CaseTests tests);

}  // namespace edgecase
