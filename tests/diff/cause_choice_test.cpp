// SPDX-License-Identifier: MIT
//
// Which of several causes that explain a primitive is named: what speaks for each in the run, what
// speaks against it, and whether the specification leaves it open.
#include <gtest/gtest.h>

#include <deque>

#include "tests/diff/judged_results.h"

namespace edgecase {
namespace {

TEST(CauseChoice, TheCauseThatExplainsMostOfTheRunWins) {
  const std::string a = "triangle.fill-rule=left-bottom", b = "triangle.fill-rule=bottom-left";
  std::deque<Result> results = {triangle_result({a, b}), triangle_result({b}),
                                triangle_result({a, b})};
  judge_all(results);
  for (const Result& result : results) {
    EXPECT_EQ(result.disagreements[0].cause, b);
    EXPECT_EQ(result.verdict, Verdict::convention);
  }
  std::deque<Result> tied = {triangle_result({a, b}), triangle_result({a, b})};
  judge_all(tied);
  EXPECT_EQ(tied[0].disagreements[0].cause, a) << "of several that tie, the first of the catalogue";
}

// An agreeing case that an alternative would have drawn otherwise speaks against it.
TEST(CauseChoice, WhatAgreeingCasesRefuteIsNotTheCause) {
  const std::string a = "triangle.snap=8-half-even", b = "triangle.snap=4-half-even";
  std::deque<Result> results = {triangle_result({a, b}), triangle_result({a, b}),
                                agreeing_but_for(a)};
  judge_all(results);
  EXPECT_EQ(results[0].disagreements[0].cause, b);
  EXPECT_EQ(results[2].verdict, Verdict::agree);
}

TEST(CauseChoice, AnOpenChoiceComesBeforeAnIllegalOne) {
  const std::string illegal = "triangle.fill-rule=closed", open = "triangle.fill-rule=left-bottom";
  std::deque<Result> results = {triangle_result({illegal, open}), triangle_result({illegal}),
                                triangle_result({illegal})};
  judge_all(results);
  EXPECT_EQ(results[0].disagreements[0].cause, open);
  EXPECT_EQ(results[1].disagreements[0].cause, illegal);
}

TEST(CauseChoice, ALargerOpenChoiceMustBeWhatTheRunSpeaksFor) {
  const std::string illegal = "triangle.fill-rule=closed";
  const std::string order = "triangle.fill-rule=left-bottom";
  const std::string open = order + " + triangle.snap=8-half-even";
  std::deque<Result> results = {triangle_result({illegal, open})};
  judge_all(results);
  EXPECT_EQ(results[0].disagreements[0].cause, open);
  results = {triangle_result({illegal, open}), agreeing_but_for(order)};
  judge_all(results);
  EXPECT_EQ(results[0].disagreements[0].cause, illegal);
}

// A fault draws by chance what an open choice draws; where that is refuted and the fault is not,
// and explains more, it is the fault.
TEST(CauseChoice, AnOpenChoiceThatTheRunRefutesDoesNotHideAFault) {
  const std::string fault = "triangle.fill-rule=closed", open = "triangle.fill-rule=left-bottom";
  std::deque<Result> results = {triangle_result({open, fault}), triangle_result({open, fault}),
                                triangle_result({fault})};
  judge_all(results);
  EXPECT_EQ(results[0].disagreements[0].cause, open) << "nothing speaks against it";
  results.push_back(agreeing_but_for(open));
  judge_all(results);
  EXPECT_EQ(results[0].disagreements[0].cause, fault);
  results.push_back(agreeing_but_for(fault));
  judge_all(results);
  EXPECT_EQ(results[0].disagreements[0].cause, open) << "the fault is refuted, too";
  // A fault that explains no more than the open choice is not likelier.
  results = {triangle_result({open, fault}), triangle_result({open}), agreeing_but_for(open)};
  judge_all(results);
  EXPECT_EQ(results[0].disagreements[0].cause, open);
}

// No conforming choice makes a hole in a shared edge: what explains more of the run is the cause.
TEST(CauseChoice, WhatIsIllegalSpeaksForNoOpenChoice) {
  const std::string illegal = "triangle.fill-rule=closed", open = "triangle.fill-rule=left-bottom";
  std::deque<Result> results = {triangle_result({open, illegal}), triangle_result({illegal})};
  results[0].disagreements[0].legality = Legality::illegal;
  results[0].disagreements[0].rule = RuleId::triangle_shared_edge;
  judge_all(results);
  EXPECT_EQ(results[0].disagreements[0].cause, illegal);
  // A fault of another kind, or of another primitive, is no evidence here.
  for (const bool value : {true, false}) {
    std::deque<Result> others = {triangle_result({open, illegal}), triangle_result({illegal})};
    Disagreement fault;
    fault.primitive = value ? 0 : 1;
    fault.kind = value ? DisagreementKind::value : DisagreementKind::extra;
    fault.rule = value ? RuleId::attribute_flat : RuleId::triangle_fill_rule;
    others[0].disagreements.push_back(fault);
    judge_all(others);
    EXPECT_EQ(others[0].disagreements[0].cause, open);
  }
}

}  // namespace
}  // namespace edgecase
