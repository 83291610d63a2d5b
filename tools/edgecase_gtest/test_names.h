// SPDX-License-Identifier: MIT
//
// The names of cases as GoogleTest tests.
//
// In --gtest_filter a colon separates patterns and a minus begins exclusions; deqp-runner writes
// names into CSV files; a dot ends the suite's name. So a name is the case's id with only letters,
// digits, '=' and '/':
//
//   lines/short/every-place:start=#9:end=-1
//
// is the test every_place/start=_9/end=_1 of the suite lines/short.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "suite/selection.h"

namespace edgecase {

struct TestName {
  std::string suite;  // folders of the id; "cases" if it has none
  std::string test;   // the file and, after slashes, the values of a sweep
};

// The text with '_' for every character that is not allowed in a name.
std::string name_text(std::string text);

// `prefix`: put before the suite; empty, or the renderer's name with a slash.
TestName test_name_of(const std::string& prefix, const std::string& id);

// The suite with one test for each case file that cannot be loaded.
constexpr const char* kFilesSuite = "case_files";

// Narrows the selection to the files of the tests that `filter` (of --gtest_filter) names in full,
// so that runners of groups of tests do not load the whole suite for each group. A filter with
// wildcards leaves the selection unchanged. Returns true if it was narrowed.
bool narrow_to_filter(const std::string& filter, std::span<const std::string> prefixes,
                      Selection& selection);

}  // namespace edgecase
