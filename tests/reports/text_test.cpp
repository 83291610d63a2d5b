// SPDX-License-Identifier: MIT
#include "reports/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/reports/sample.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

TEST(ReportText, ControlCharactersAreShownNotDropped) {
  EXPECT_EQ(xml_text(std::string("a\x01\x1f\x7f\0b", 6)), "a\u2401\u241F\u2421\u2400b");
  EXPECT_EQ(xml_text("tab\tline\n"), "tab\tline\n");
  EXPECT_EQ(one_line("a\u202Eb"), "a\uFFFDb");
  // What GitHub's runner would obey in a log.
  EXPECT_EQ(one_line("::error::a"), ": :error::a");
  EXPECT_EQ(xml_text("a\n \u00a0::set-output name=b::\n###[group]"),
            "a\n \u00a0: :set-output name=b::\n### [group]");
  EXPECT_EQ(xml_text(":::"), ": : :");
  EXPECT_EQ(one_line("std::string a##b [c]"), "std::string a##b [c]");
  EXPECT_EQ(one_line("tab\tline\n\x1b[31m"), "tab\u2409line\u240A\u241B[31m");
}

TEST(ReportText, InvalidUtf8BecomesReplacementCharacters) {
  EXPECT_EQ(xml_text("\xFF"), "\uFFFD");
  EXPECT_EQ(xml_text("\xC0\xAF"), "\uFFFD\uFFFD");
  EXPECT_EQ(xml_text("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(xml_text("\xE2\x82"), "\uFFFD\uFFFD");
  EXPECT_EQ(xml_text("\xF4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(xml_text("\xEF\xBF\xBF"), "\uFFFD");
}

TEST(ReportText, ValidUtf8StaysAsItIs) {
  const std::string text = "\u00e9 \u20ac \U0001F600 \u05d0";
  EXPECT_EQ(xml_text(text), text);
}

TEST(ReportText, HeadlineCountsDisagreementsAndValues) {
  Result result;
  result.verdict = Verdict::permitted;
  result.disagreements = {sample::disagreement(1, 2, DisagreementKind::extra, true)};
  result.values.push_back({});
  result.values[0].differing = {{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(headline(result),
            "permitted, expected, 1 disagreement, 2 values within what is permitted");
  EXPECT_EQ(count_differences(result), 3u);
}

TEST(ReportText, DescribesADisagreementWithItsRule) {
  EXPECT_EQ(describe(sample::disagreement(3, 4, DisagreementKind::missing, false), 1),
            "pixel (3, 4), primitive 0, missing, line.diamond-exit, not allowed by ruling 1: "
            "Pixel (3, 4) differs.");
}

TEST(ReportText, DescribesValuesWithTheirMeanTheirWorstAndTheirRange) {
  ValueAggregate values;
  values.attribute = "dFdxFine";
  values.compared = 40;
  values.components = 160;
  values.differing = {{1, 2, 0}, {3, 4, 0}};
  values.worst = {3, 4, 0};
  values.worst_exact = 0.5;
  values.worst_rendered = 0.5625;
  values.worst_ulp = 12.5;
  values.mean_ulp = 0.375;
  values.worst_relative = 0.0625;
  EXPECT_EQ(describe(values),
            "dFdxFine: 2 of 40 values differ within what is permitted, worst 12.5 ULP at pixel "
            "(3, 4): 0.5 exact, 0.5625 rendered; mean 0.375 ULP, at most 0.0625 of the attribute's "
            "range");
  values.cause = cause_named("texture.log2=mantissa-8");
  EXPECT_THAT(describe(values),
              testing::StartsWith("dFdxFine: 2 of 40 values differ by texture.log2=mantissa-8, "));
}

}  // namespace
}  // namespace edgecase
