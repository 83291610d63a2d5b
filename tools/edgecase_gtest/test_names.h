// SPDX-License-Identifier: MIT
//
// The names that cases have as GoogleTest tests.
//
// In --gtest_filter a colon separates patterns and a minus begins what is left out; deqp-runner
// writes names into CSV files; a dot ends the suite's name. So a name is the case's id with
// letters, digits, '=' and '/' alone: lines/short/every-place:start=#9:end=-1 is the test
// every_place/start=_9/end=_1 of the suite lines/short.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "run/selection.h"

namespace edgecase {

struct TestName {
  std::string suite;  // folders of the id; "cases" where it has none
  std::string test;   // the file, and behind slashes the values of a sweep
};

// The text with '_' for every character that a name may not hold.
std::string name_text(std::string text);

// `prefix` stands before the suite: empty, or the renderer's name with a slash.
TestName test_name_of(const std::string& prefix, const std::string& id);

// The suite of the tests that stand for case files which cannot be loaded, one a file.
constexpr const char* kFilesSuite = "case_files";

// Narrows the selection to the files whose tests `filter`, as --gtest_filter has it, asks for by
// whole names: who runs thousands of tests group by group should not load the suite for each. A
// filter with wildcards leaves the selection alone. Returns whether it was narrowed.
bool narrow_to_filter(const std::string& filter, std::span<const std::string> prefixes,
                      Selection& selection);

}  // namespace edgecase
