// SPDX-License-Identifier: MIT
//
// What is unexpected however the run will be read, and what only the whole run can tell.
#include "run/judging.h"

#include <gtest/gtest.h>

#include "results/standing.h"
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

// No answer is sure that the run's end holds otherwise.
TEST(EarlyJudgement, IsThatOfTheRunsEnd) {
  for (const Latitude latitude : {Latitude::opengl, Latitude::none})
    for (const Result& answer :
         {Result{}, differing(false), forbidden(), failed(), failed(FailureKind::unsupported)}) {
      CaseResults one;
      one.id = "folder/case";
      one.surface = "fbo";
      one.results = {answer};
      Results results;
      results.latitude = latitude;
      results.renderers.resize(1);
      results.cases.push_back(one);
      judge_all(results);
      conclude(results, {});
      EXPECT_EQ(surely(answer, nullptr, latitude), count_unexpected(results) == 1);
    }
}

Result values_only() {
  Result result;
  result.values.resize(1);
  result.values[0].differing.resize(3);
  return result;
}

// All that judging decides.
std::string judgement_of_all(const Results& results) {
  std::string text;
  for (const auto& info : results.renderers)
    for (const auto& [trait, value] : info.traits) text += trait + "=" + value + "\n";
  for (const CaseResults& one : results.cases)
    for (const Result& result : one.results) {
      text += one.id + " " + describe(judgement_of(result)) + " " +
              std::to_string(result.pixel_counts[Verdict::permitted]);
      for (const Disagreement& d : result.disagreements)
        text += " " + std::to_string(static_cast<int>(d.legality)) + text_of(d.cause);
      text += "\n";
    }
  return text;
}

// Each case when it is complete, and at the end those for which the run matters.
TEST(Judging, InTwoStepsIsJudgingAtOnce) {
  std::vector<CaseResults> cases;
  const std::vector<Result> answers = {differing(true),  values_only(), failed(),
                                       differing(false), forbidden(),   Result()};
  for (std::size_t i = 0; i < 2 * answers.size(); ++i) {
    CaseResults one;
    one.id = std::to_string(i);
    one.surface = i < answers.size() ? "fbo" : "window";
    one.results = {answers[i % answers.size()], answers[(i + i / answers.size()) % answers.size()]};
    for (Result& result : one.results) result.pixel_counts[Verdict::agree] = 20;
    cases.push_back(std::move(one));
  }
  Results at_once;
  at_once.renderers.resize(2);
  Results in_steps = at_once;
  RunReaders readers;
  for (CaseResults& one : cases) {
    at_once.cases.push_back(one);
    readers.add(one);
    judge_alone(one, in_steps.latitude);
    in_steps.cases.push_back(one);
  }
  judge_all(at_once);
  EXPECT_NE(judgement_of_all(at_once), judgement_of_all(in_steps)) << "the second step is empty";
  judge_rest(in_steps, readers.readings());
  EXPECT_EQ(judgement_of_all(at_once), judgement_of_all(in_steps));
}

}  // namespace
}  // namespace edgecase
