// SPDX-License-Identifier: MIT
#include "reports/summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/reports/sample.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string summary_of(const Results& results, bool color) {
  std::ostringstream out;
  write_summary(results, color, out);
  return out.str();
}

TEST(Summary, TableHasEveryVerdictAndRenderer) {
  const std::string text = summary_of(sample::results(), false);
  for (const char* word : {"violation", "permitted", "convention", "agree", "not-run",
                           "osmesa:llvmpipe", "osmesa:softpipe", "egl:llvmpipe", "egl:softpipe"})
    EXPECT_THAT(text, HasSubstr(word));
  EXPECT_THAT(text, HasSubstr("and "));
}

TEST(Summary, WithoutColourThereIsNoEscape) {
  EXPECT_THAT(summary_of(sample::results(), false), Not(HasSubstr("\x1b")));
  EXPECT_THAT(summary_of(sample::results(), true), HasSubstr("\x1b["));
}

TEST(Summary, ListsUnexpectedResultsWithTheirFirstExplanation) {
  Results results;
  results.renderers.resize(1);
  results.renderers[0].name = "exec:./mine";
  for (int i = 0; i < 23; ++i) {
    CaseResults one;
    one.id = "case-" + std::to_string(i);
    one.results.resize(1);
    one.results[0].verdict = Verdict::violation;
    one.results[0].standing = Standing::unexpected;
    one.results[0].disagreements = {sample::disagreement(i, 0, DisagreementKind::extra, false)};
    results.cases.push_back(one);
  }
  const std::string text = summary_of(results, false);
  EXPECT_THAT(text, HasSubstr("case-19 exec:./mine violation, unexpected\n"
                              "      pixel (19, 0): Pixel (19, 0) differs."));
  EXPECT_THAT(text, Not(HasSubstr("case-20 ")));
  EXPECT_THAT(text, HasSubstr("and 3 more"));
}

TEST(Summary, NoTextSteersTheTerminal) {
  Results results;
  results.diagnostics = {{"a\x1b[2J.json", 1, "", "broken\r", ""}};
  const std::string text = summary_of(results, false);
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
  EXPECT_THAT(text, Not(HasSubstr("\r")));
}

}  // namespace
}  // namespace edgecase
