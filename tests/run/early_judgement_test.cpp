// SPDX-License-Identifier: MIT
//
// What is unexpected however the run will be read, and what only the whole run can tell.
#include "run/early_judgement.h"

#include <gtest/gtest.h>

#include "diff/judge.h"
#include "rules/all_rules.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

// One pixel of a triangle or a line that differs, and a value inside what is permitted.
Result differing(bool of_a_line, int x = 3) {
  Result result;
  Disagreement d;
  d.x = x;
  d.primitive = 0;
  d.rule = of_a_line ? RuleId::line_diamond_exit : RuleId::triangle_fill_rule;
  d.legality = Legality::legal;
  result.disagreements = {d};
  result.values.resize(1);
  result.values[0].differing.resize(1);
  result.evidence.resize(1);
  if (of_a_line) result.evidence[0].illegal_line_snaps = {"none"};
  if (of_a_line) result.illegal_line_snaps = {"none"};
  return result;
}

Expectation entry_of(Result result) {
  Result* const only = &result;
  judge({&only, 1}, Latitude::opengl);
  return {result.verdict, result.fingerprint, "known", ""};
}

bool surely(const Result& result, const Expectation* entry) {
  return is_surely_unexpected(result, Latitude::opengl, entry);
}

TEST(EarlyJudgement, OfCasesWithoutAnEntry) {
  EXPECT_FALSE(surely(Result{}, nullptr));
  EXPECT_TRUE(surely(differing(false), nullptr));
  EXPECT_TRUE(surely(differing(true), nullptr));
  Result failed;
  failed.failure = Failure{FailureKind::crashed, "signal 11"};
  EXPECT_TRUE(surely(failed, nullptr));
}

// The number of some contested ruling.
int contested_ruling() {
  for (const Rule& rule : all_rules())
    for (const Ruling& ruling : rule.rulings)
      if (ruling.source.basis == Basis::contested) return ruling.number;
  return 0;
}

// It may be tolerated.
TEST(EarlyJudgement, OfWhatMayBeContestedNothingIsSure) {
  Result result = differing(false);
  result.disagreements[0].legality = Legality::illegal;
  result.disagreements[0].ruling = 4;
  EXPECT_TRUE(surely(result, nullptr));
  result.disagreements[0].ruling = contested_ruling();
  EXPECT_FALSE(surely(result, nullptr));
}

TEST(EarlyJudgement, OfCasesWithOne) {
  const Expectation known = entry_of(differing(false));
  EXPECT_FALSE(surely(differing(false), &known));
  EXPECT_TRUE(surely(differing(false, 4), &known));
  EXPECT_TRUE(surely(Result{}, &known)) << "an agreement that nobody expects";
  Result failed;
  failed.failure = Failure{FailureKind::crashed, "signal 11"};
  EXPECT_TRUE(surely(failed, &known));
  const Expectation crash = entry_of(failed);
  EXPECT_FALSE(surely(failed, &crash));
}

// The verdict, and with it whether values count in the fingerprint, is the run's to say.
TEST(EarlyJudgement, LinesAreLeftToTheRunsReading) {
  const Expectation legal = entry_of(differing(true));
  Result result = differing(true);
  result.illegal_line_snaps = result.evidence[0].illegal_line_snaps = {};
  EXPECT_FALSE(surely(differing(true), &legal));
  const Expectation other = {Verdict::violation, "0123456789abcdef", "known", ""};
  EXPECT_FALSE(surely(differing(true), &other));
  EXPECT_TRUE(surely(result, &other)) << "legal under every reading";
}

}  // namespace
}  // namespace edgecase
