// SPDX-License-Identifier: MIT
//
// What is unexpected however the run will be read, and what only the whole run can tell.
#include "run/judging.h"

#include <gtest/gtest.h>

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

KnownFault fault_of(const Result& result) {
  KnownFault fault;
  fault.id = "known";
  if (!result.failure) fault.rules = {result.disagreements.at(0).rule};
  fault.kinds = {result.failure ? name_of(result.failure->kind) : "missing"};
  fault.cases = {"folder"};
  fault.reason = "known";
  return fault;
}

bool surely(const Result& result, const KnownFault* fault = nullptr,
            Latitude latitude = Latitude::opengl) {
  Case one;
  one.id = "folder/case";
  std::vector<const KnownFault*> faults;
  if (fault != nullptr) faults.push_back(fault);
  return is_surely_unexpected(one, result, latitude, faults);
}

Result forbidden(int x = 3) {
  Result result = differing(false, x);
  result.disagreements[0].legality = Legality::illegal;
  result.disagreements[0].ruling = 4;
  return result;
}

Result failed(FailureKind kind = FailureKind::crashed) {
  Result result;
  result.failure = Failure{kind, "signal 11"};
  return result;
}

TEST(EarlyJudgement, OfWhatNothingAccountsFor) {
  EXPECT_FALSE(surely(Result{}));
  EXPECT_FALSE(surely(differing(false))) << "it is legal";
  EXPECT_TRUE(surely(forbidden()));
  EXPECT_TRUE(surely(failed()));
  EXPECT_FALSE(surely(failed(FailureKind::unsupported)));
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
  Result result = forbidden();
  result.disagreements[0].ruling = contested_ruling();
  EXPECT_FALSE(surely(result));
}

TEST(EarlyJudgement, OfWhatIsKnown) {
  const KnownFault fault = fault_of(forbidden());
  EXPECT_FALSE(surely(forbidden(), &fault));
  Result other = forbidden();
  other.disagreements[0].kind = DisagreementKind::extra;
  EXPECT_TRUE(surely(other, &fault));
  EXPECT_TRUE(surely(failed(), &fault));
  const KnownFault crash = fault_of(failed());
  EXPECT_FALSE(surely(failed(), &crash));
  EXPECT_TRUE(surely(failed(FailureKind::garbage), &crash));
}

// What a line's verdict is depends on the reading of all lines of the run.
TEST(EarlyJudgement, LinesAreLeftToTheRunsReading) {
  Result line = differing(true);
  line.disagreements[0].legality = Legality::illegal;
  line.disagreements[0].ruling = 1;
  EXPECT_FALSE(surely(line));
}

// Without latitude every difference is a violation, and nothing is known.
TEST(EarlyJudgement, WithoutLatitude) {
  const KnownFault fault = fault_of(forbidden());
  EXPECT_TRUE(surely(differing(false), &fault, Latitude::none));
  EXPECT_FALSE(surely(Result{}, &fault, Latitude::none));
}

}  // namespace
}  // namespace edgecase
