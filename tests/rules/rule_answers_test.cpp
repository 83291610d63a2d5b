// SPDX-License-Identifier: MIT
#include "rules/rule_answers.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "rules/all_rules.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

// An answer that agrees, and that each of these alternatives would have drawn otherwise.
Result agreeing_but_for(const std::vector<std::string>& refuted) {
  Result result;
  for (const std::string& name : refuted) result.refuted.add(cause_named(name).parts.at(0));
  return result;
}

// An answer with a primitive that each of these causes draws.
Result explained_by(const std::vector<std::string>& causes) {
  Result result;
  result.evidence = {{0, causes_named(causes), {}, ""}};
  return result;
}

RuleAnswers answers_on(const std::string& rule, const RuleAnswersGatherer& gatherer) {
  for (const RuleAnswers& answers : gatherer.answers())
    if (name_of(answers.rule) == rule) return answers;
  return {};
}

std::size_t speaking_for(const std::string& alternative, const RuleAnswersGatherer& gatherer) {
  const std::string rule = alternative.substr(0, alternative.find('='));
  return answers_on(rule, gatherer)
      .speaking_for(alternative_id(rule_named(rule), alternative.substr(rule.size() + 1)).index);
}

TEST(RuleAnswers, AnAgreeingAnswerSpeaksAgainstWhatWouldDiffer) {
  RuleAnswersGatherer gatherer;
  gatherer.add(agreeing_but_for({"triangle.fill-rule=open", "triangle.fill-rule=closed"}));
  gatherer.add(agreeing_but_for({"triangle.fill-rule=open"}));
  gatherer.add(agreeing_but_for({}));
  EXPECT_EQ(answers_on("triangle.fill-rule", gatherer).asked, 2u);
  EXPECT_EQ(speaking_for("triangle.fill-rule=open", gatherer), 0u);
  EXPECT_EQ(speaking_for("triangle.fill-rule=closed", gatherer), 1u);
  EXPECT_EQ(speaking_for("triangle.fill-rule=left-bottom", gatherer), 2u);
  EXPECT_EQ(gatherer.answers().size(), 1u) << "no other rule was asked";
}

TEST(RuleAnswers, ADifferenceSpeaksForWhatDrawsIt) {
  RuleAnswersGatherer gatherer;
  for (int i = 0; i < 19; ++i)
    gatherer.add(explained_by({"triangle.fill-rule=right-top", "triangle.fill-rule=right-bottom"}));
  gatherer.add(agreeing_but_for({"triangle.fill-rule=right-bottom"}));
  EXPECT_EQ(speaking_for("triangle.fill-rule=right-top", gatherer), 20u);
  EXPECT_EQ(speaking_for("triangle.fill-rule=right-bottom", gatherer), 19u);
  EXPECT_EQ(speaking_for("triangle.fill-rule=left-bottom", gatherer), 1u);
  EXPECT_EQ(remaining_of(answers_on("triangle.fill-rule", gatherer)), "right-top");
}

TEST(RuleAnswers, WhatNothingTellsApartRemainsTogether) {
  RuleAnswersGatherer gatherer;
  gatherer.add(explained_by({"triangle.fill-rule=right-top", "triangle.fill-rule=right-bottom"}));
  EXPECT_EQ(remaining_of(answers_on("triangle.fill-rule", gatherer)), "right-bottom or right-top");
}

TEST(RuleAnswers, BelowNineInTenNoneIsKnown) {
  RuleAnswersGatherer gatherer;
  for (int i = 0; i < 3; ++i) gatherer.add(explained_by({"triangle.fill-rule=right-top"}));
  gatherer.add(explained_by({"triangle.fill-rule=open"}));
  EXPECT_EQ(remaining_of(answers_on("triangle.fill-rule", gatherer)), "none known");
}

TEST(RuleAnswers, PairsRivalsAndRulesWithoutAlternativesSayNothing) {
  RuleAnswersGatherer gatherer;
  gatherer.add(explained_by({"triangle.fill-rule=open", "triangle.snap=8-half-even"}));
  gatherer.add(explained_by({"triangle.fill-rule=open + triangle.snap=8-half-even"}));
  gatherer.add(explained_by({"window.origin"}));
  EXPECT_TRUE(gatherer.answers().empty());
}

TEST(RuleAnswers, TheOrderOfAnswersDoesNotMatterAndPartsAddUp) {
  const std::vector<Result> answers{explained_by({"triangle.fill-rule=open"}),
                                    agreeing_but_for({"triangle.fill-rule=open"}),
                                    agreeing_but_for({"line.snap=8-truncate"})};
  RuleAnswersGatherer forward, backward;
  for (const Result& answer : answers) forward.add(answer);
  std::for_each(answers.rbegin(), answers.rend(),
                [&](const Result& answer) { backward.add(answer); });
  EXPECT_EQ(forward.answers(), backward.answers());
}

}  // namespace
}  // namespace edgecase
