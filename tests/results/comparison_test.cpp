// SPDX-License-Identifier: MIT
//
// What became of each case, in each direction, and by which rule and cause.
#include "results/comparison.h"

#include <gmock/gmock.h>

#include "tests/results/sample_results.h"
#include "tests/support/causes.h"
#include "tests/support/edit.h"

namespace edgecase {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Comparison compared(const Results& before, const Results& after) {
  auto outcome = compare_results(before, after);
  if (const auto* fault = std::get_if<std::string>(&outcome)) throw std::runtime_error(*fault);
  return std::get<Comparison>(std::move(outcome));
}

// What becomes of a case whose answers are these.
std::optional<ChangeKind> change(Verdict from, Verdict to) {
  const Comparison comparison = compared(results_with({from}), results_with({to}));
  const auto& cases = comparison.renderers.at(0).cases;
  EXPECT_EQ(differs(comparison), !cases.empty());
  EXPECT_EQ(comparison.renderers[0].same, cases.empty() ? 1u : 0u);
  if (cases.empty()) return std::nullopt;
  EXPECT_EQ(cases[0].before->verdict, from);
  EXPECT_EQ(cases[0].after->verdict, to);
  return cases[0].change;
}

TEST(Comparison, OfAllPairsOfVerdicts) {
  using enum Verdict;
  for (Verdict same : {agree, convention, permitted, violation, not_run})
    EXPECT_EQ(change(same, same), std::nullopt);
  for (Verdict other : {convention, permitted, violation}) {
    EXPECT_EQ(change(agree, other), ChangeKind::new_disagreement);
    EXPECT_EQ(change(other, agree), ChangeKind::fixed);
    EXPECT_EQ(change(other, not_run), ChangeKind::not_run);
    EXPECT_EQ(change(not_run, other), ChangeKind::runs);
  }
  EXPECT_EQ(change(agree, not_run), ChangeKind::not_run);
  EXPECT_EQ(change(not_run, agree), ChangeKind::runs);
  EXPECT_EQ(change(convention, permitted), ChangeKind::worse);
  EXPECT_EQ(change(permitted, violation), ChangeKind::worse);
  EXPECT_EQ(change(violation, convention), ChangeKind::better);
}

TEST(Comparison, AnotherFingerprintIsAChange) {
  Results after = results_with({Verdict::violation, Verdict::not_run});
  after.cases.answer(0, 0).fingerprint = "other";
  after.cases.answer(1, 0).fingerprint = "timed-out";
  const auto renderer =
      compared(results_with({Verdict::violation, Verdict::not_run}), after).renderers[0];
  ASSERT_EQ(renderer.cases.size(), 2u);
  EXPECT_EQ(renderer.cases[0].change, ChangeKind::changed);
  EXPECT_EQ(renderer.cases[1].change, ChangeKind::changed);
  EXPECT_EQ(renderer.counts.at(ChangeKind::changed), 2u);
}

TEST(Comparison, CasesAppearAndDisappear) {
  Results before = results_with({Verdict::agree, Verdict::agree, Verdict::violation});
  Results after = results_with({Verdict::agree, Verdict::agree, Verdict::violation});
  before.cases.erase_if([](const CaseOutline& one) { return one.id == "a"; });
  after.cases.erase_if([](const CaseOutline& one) { return one.id == "c"; });
  const auto renderer = compared(before, after).renderers[0];
  ASSERT_EQ(renderer.cases.size(), 2u);
  EXPECT_EQ(renderer.same, 1u);
  EXPECT_EQ(renderer.cases[0].change, ChangeKind::appeared);
  EXPECT_FALSE(renderer.cases[0].before);
  EXPECT_EQ(renderer.cases[1].change, ChangeKind::disappeared);
  EXPECT_FALSE(renderer.cases[1].after);
  ASSERT_EQ(renderer.clusters.size(), 1u) << "what agrees is by no rule";
  EXPECT_EQ(renderer.clusters[0].change, ChangeKind::disappeared);
}

TEST(Comparison, ClustersCountCasesByRuleAndCause) {
  const Results before =
      results_with({Verdict::agree, Verdict::agree, Verdict::agree, Verdict::permitted});
  Results after =
      results_with({Verdict::violation, Verdict::violation, Verdict::not_run, Verdict::agree});
  edit(after.cases, 1)->results[0].disagreements[1].rule = RuleId::line_diamond_exit;
  edit(after.cases, 1)->results[0].disagreements[1].cause = cause_named("line.algorithm=bresenham");
  const auto clusters = compared(before, after).renderers[0].clusters;
  ASSERT_EQ(clusters.size(), 4u);
  const auto words = [&](std::size_t i) {
    const ChangeCluster& c = clusters[i];
    return std::string(name_of(c.change)) + " " + c.rule + " " + c.cause + " " +
           std::to_string(c.cases) + " " + std::to_string(c.disagreements) + " " + c.first_case;
  };
  EXPECT_EQ(words(0), "new-disagreement triangle.fill-rule  2 3 a");
  EXPECT_EQ(words(1), "new-disagreement line.diamond-exit line.algorithm=bresenham 1 1 b");
  EXPECT_EQ(words(2), "not-run not-run crashed 1 1 c");
  EXPECT_EQ(words(3), "fixed triangle.fill-rule  1 2 d") << "told by the old answer";
}

TEST(Comparison, FactsAreToldAndCountForNothing) {
  Results before = results_with({Verdict::agree});
  Results after = before;
  after.tool = "edgecase 9";
  after.policy = "vulkan-strict";
  after.latitude = Latitude::none;
  after.renderers[0].version = "24.1";
  after.renderers[0].traits["samples"] = "4";
  after.interrupted = true;
  after.left_out = 3;
  const RuleId fill = rule_named("triangle.fill-rule");
  RuleAnswers answers{fill, 9, std::vector<std::size_t>(rule_of(fill).alternatives.size(), 9)};
  answers.against.at(alternative_id(fill, "open").index) = 0;
  after.rules[after.renderers[0].name]["window"] = {answers};
  before.rules[before.renderers[0].name]["fbo"] = {answers};
  answers.against.at(alternative_id(fill, "closed").index) = 0;
  after.rules[after.renderers[0].name]["fbo"] = {answers};
  const Comparison comparison = compared(before, after);
  EXPECT_FALSE(differs(comparison));
  std::vector<std::string> what;
  for (const FactChange& fact : comparison.facts) what.push_back(fact.what);
  EXPECT_THAT(what, ElementsAre("tool", "policy", "latitude", "run"));
  EXPECT_THAT(comparison.facts[3].after, HasSubstr("3 cases missing"));
  what.clear();
  for (const FactChange& fact : comparison.renderers[0].facts) what.push_back(fact.what);
  EXPECT_THAT(what, ElementsAre("version", "samples", "triangle.fill-rule, fbo"));
  EXPECT_EQ(comparison.renderers[0].facts[2].before, "open");
  EXPECT_EQ(comparison.renderers[0].facts[2].after, "open or closed");
}

TEST(Comparison, MatchesRenderersByNameOrTheOnlyOnes) {
  Results one = results_with({Verdict::agree});
  Results other = one;
  other.renderers[0].name = "another";
  EXPECT_EQ(compared(one, other).renderers.size(), 1u);
  EXPECT_FALSE(differs(compared(one, other)));

  Results two = one;
  two.renderers.push_back({"second", "", "", "", 4, {}});
  edit(two.cases, 0)->results.push_back(two.cases[0].results[0]);
  const Comparison both = compared(two, one);
  EXPECT_EQ(both.renderers.size(), 1u);
  EXPECT_THAT(both.only_before, ElementsAre("second"));
  EXPECT_TRUE(differs(both));
  EXPECT_THAT(compared(one, two).only_after, ElementsAre("second"));
  const auto none = compare_results(two, other);
  ASSERT_TRUE(std::holds_alternative<std::string>(none));
  EXPECT_THAT(std::get<std::string>(none), HasSubstr("no renderer is in both"));
}

TEST(Comparison, AsJson) {
  Results after = results_with({Verdict::violation});
  edit(after.cases, 0)->results[0].disagreements.resize(1);
  const std::string json = comparison_json(compared(results_with({Verdict::agree}), after));
  EXPECT_THAT(json, HasSubstr("\"edgecase_comparison\": 1"));
  EXPECT_THAT(json, HasSubstr("\"change\": \"new-disagreement\""));
  EXPECT_THAT(json, HasSubstr("\"fingerprint\": \"print-a\""));
}

}  // namespace
}  // namespace edgecase
