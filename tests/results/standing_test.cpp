// SPDX-License-Identifier: MIT
//
// How answers stand to known faults, and what a run shows of the faults.
#include "results/standing.h"

#include <gtest/gtest.h>

#include "tests/results/sample_results.h"
#include "tests/support/causes.h"
#include "tests/support/edit.h"

namespace edgecase {
namespace {

// One fault of the driver "fake" that accounts for what results_with() forbids of these cases.
KnownFaults fault_of(std::vector<std::string> cases,
                     std::map<std::string, std::size_t> counts = {}) {
  KnownFault fault;
  fault.id = "fill";
  fault.rules = {RuleId::triangle_fill_rule};
  fault.kinds = {"missing"};
  fault.cases = std::move(cases);
  fault.cases_on = std::move(counts);
  fault.reason = "it fills too little";
  return {"fake", {fault}};
}

Standing standing_of(Results& results, const std::vector<KnownFaults>& known) {
  apply_known_faults(results, known);
  return results.cases.outline(0).answers[0].standing;
}

const std::string& words(const Results& results) {
  return results.cases.outline(0).answers[0].standing_reason;
}

TEST(Standing, OfLegalAnswersIsExpected) {
  for (const Verdict verdict : {Verdict::agree, Verdict::convention, Verdict::permitted}) {
    Results results = results_with({verdict});
    EXPECT_EQ(standing_of(results, {}), Standing::expected) << name_of(verdict);
    EXPECT_EQ(words(results), "");
    EXPECT_EQ(standing_of(results, {fault_of({"a"})}), Standing::expected);
    EXPECT_TRUE(results.cases[0].results[0].faults.empty());
  }
}

TEST(Standing, OfAViolationIsKnownWhereAFaultAccountsForAllOfIt) {
  Results results = results_with({Verdict::violation});
  EXPECT_EQ(standing_of(results, {}), Standing::unexpected);
  EXPECT_EQ(words(results), "no known fault accounts for this");
  EXPECT_EQ(standing_of(results, {fault_of({"b"})}), Standing::unexpected);
  KnownFaults other = fault_of({"a"});
  other.driver = "other";
  EXPECT_EQ(standing_of(results, {other}), Standing::unexpected);
  EXPECT_EQ(standing_of(results, {fault_of({"a"})}), Standing::known);
  EXPECT_EQ(words(results), "it fills too little (fill)");
  EXPECT_EQ(results.cases[0].results[0].faults, std::vector<std::string>{"fill"});

  edit(results.cases, 0)->results[0].disagreements[1].kind = DisagreementKind::extra;
  EXPECT_EQ(standing_of(results, {fault_of({"a"})}), Standing::unexpected);
  EXPECT_EQ(words(results),
            "no known fault accounts for 1 of 2 differences; known: it fills too little (fill)");
  edit(results.cases, 0)->results[0].disagreements[1].legality = Legality::contested;
  EXPECT_EQ(standing_of(results, {fault_of({"a"})}), Standing::known);
}

// A violation without a difference that is forbidden is no known fault.
TEST(Standing, OfAViolationWithoutADifferenceIsUnexpected) {
  Results results = results_with({Verdict::violation});
  edit(results.cases, 0)->results[0].disagreements.clear();
  EXPECT_EQ(standing_of(results, {fault_of({"a"})}), Standing::unexpected);
}

TEST(Standing, OfWhatIsContestedIsToleratedOrKnown) {
  Results results = results_with({Verdict::contested});
  results.cases.change(0, [](CaseResults& one) {
    for (Disagreement& d : one.results[0].disagreements) d.legality = Legality::contested;
  });
  EXPECT_EQ(standing_of(results, {}), Standing::tolerated);
  EXPECT_FALSE(is_unexpected(Standing::tolerated));
  hold_contested(results);
  EXPECT_EQ(results.cases[0].results[0].standing, Standing::unexpected);
  EXPECT_EQ(standing_of(results, {fault_of({"a"})}), Standing::known);
  hold_contested(results);
  EXPECT_EQ(results.cases[0].results[0].standing, Standing::known);
}

TEST(Standing, OfAnswersThatDidNotCome) {
  Results results = results_with({Verdict::not_run});
  ResultOutline& answer = results.cases.answer(0, 0);
  KnownFaults crash = fault_of({"a"});
  crash.faults[0].rules.clear();
  crash.faults[0].kinds = {"crashed"};
  EXPECT_EQ(standing_of(results, {fault_of({"a"})}), Standing::unexpected);
  EXPECT_EQ(standing_of(results, {crash}), Standing::known);
  answer.failure->kind = FailureKind::garbage;
  EXPECT_EQ(standing_of(results, {crash}), Standing::unexpected);
  answer.failure->kind = FailureKind::unavailable;
  EXPECT_EQ(standing_of(results, {crash}), Standing::unexpected);
  answer.failure->kind = FailureKind::unsupported;
  EXPECT_EQ(standing_of(results, {}), Standing::tolerated);
  hold_contested(results);
  EXPECT_EQ(answer.standing, Standing::tolerated) << "strictness is about what is contested";
}

// Neither of the two answers can be known.
TEST(Standing, OfAFlakeWhateverIsKnown) {
  Results results = results_with({Verdict::violation});
  results.cases.answer(0, 0).again = Judgement{Verdict::agree, ""};
  EXPECT_EQ(standing_of(results, {fault_of({"a"})}), Standing::flake);
  EXPECT_NE(words(results).find("when asked again agree"), std::string::npos);
}

// A policy without latitude asks for the exact side's own answer.
TEST(Standing, WithoutLatitudeNothingIsKnown) {
  Results results = results_with({Verdict::violation, Verdict::agree});
  results.latitude = Latitude::none;
  EXPECT_EQ(standing_of(results, {fault_of({"a"})}), Standing::unexpected);
  EXPECT_EQ(results.cases[1].results[0].standing, Standing::expected);
  EXPECT_TRUE(results.faults.empty());
}

// Whole results of the release 1.0, in which two cases show the fault.
Results whole_results() {
  Results results = results_with({Verdict::violation, Verdict::violation, Verdict::agree});
  results.renderers[0].version = "1.0";
  results.whole_suite = true;
  return results;
}

TEST(FaultsSeen, AreHeldAgainstTheCountOfTheirRelease) {
  const auto state = [](std::vector<std::string> cases, std::map<std::string, std::size_t> counts) {
    Results results = whole_results();
    const KnownFaults known = fault_of(std::move(cases), std::move(counts));
    apply_known_faults(results, {&known, 1});
    EXPECT_EQ(has_grown(results), results.faults.at(0).state == FaultState::grown);
    return std::pair(results.faults.at(0).state, results.faults.at(0).cases);
  };
  EXPECT_EQ(state({"a", "b"}, {{"1.0", 2}}), std::pair(FaultState::known, std::size_t{2}));
  EXPECT_EQ(state({"a", "b"}, {{"1.0", 1}}), std::pair(FaultState::grown, std::size_t{2}));
  EXPECT_EQ(state({"a", "b"}, {{"1.0", 3}}), std::pair(FaultState::shrunk, std::size_t{2}));
  EXPECT_EQ(state({"a", "b"}, {{"2.0", 1}}), std::pair(FaultState::uncounted, std::size_t{2}));
  EXPECT_EQ(state({"c"}, {{"1.0", 1}}), std::pair(FaultState::fixed, std::size_t{0}));
  EXPECT_EQ(state({"c"}, {}), std::pair(FaultState::fixed, std::size_t{0}));
}

TEST(FaultsSeen, OfPartsOfASuiteAreThoseThatShow) {
  Results results = whole_results();
  results.whole_suite = false;
  const KnownFaults known = fault_of({"a", "b"}, {{"1.0", 1}});
  apply_known_faults(results, {&known, 1});
  ASSERT_EQ(results.faults.size(), 1u);
  EXPECT_EQ(results.faults[0].state, FaultState::known) << "only a whole suite can be counted";
  const KnownFaults unseen = fault_of({"c"}, {{"1.0", 1}});
  apply_known_faults(results, {&unseen, 1});
  EXPECT_TRUE(results.faults.empty());
}

TEST(FaultsSeen, OfOtherReleasesSayNothing) {
  Results results = whole_results();
  KnownFaults known = fault_of({"a"});
  known.faults[0].versions = VersionRange{"", {2}, {}};
  apply_known_faults(results, {&known, 1});
  EXPECT_TRUE(results.faults.empty());
  EXPECT_EQ(results.cases[0].results[0].standing, Standing::unexpected);
}

// Through OpenGL ES many cases cannot be asked: a fault that does not show is no news.
TEST(FaultsSeen, ThroughOpenGlEsAreNotMissed) {
  Results results = whole_results();
  results.renderers[0] = {"egl-es:llvmpipe", "", "OpenGL ES 3.2 Mesa 22.3.6", "llvmpipe", 8, {}};
  KnownFaults known = fault_of({"c"}, {{"Mesa 22.3.6", 1}});
  known.driver = "llvmpipe";
  apply_known_faults(results, {&known, 1});
  EXPECT_TRUE(results.faults.empty());
}

// Three whole results, of which the renderer does not support the last ones.
FaultSeen seen_of(const std::vector<Verdict>& drawn, std::size_t unsupported, std::size_t before) {
  std::vector<Verdict> verdicts = drawn;
  verdicts.resize(drawn.size() + unsupported, Verdict::not_run);
  Results results = results_with(verdicts);
  results.renderers[0].version = "1.0";
  results.whole_suite = true;
  for (std::size_t i = drawn.size(); i < verdicts.size(); ++i)
    results.cases.answer(i, 0).failure = Failure{FailureKind::unsupported, "no samples"};
  const KnownFaults known = fault_of({"a", "b", "c"}, {{"1.0", before}});
  apply_known_faults(results, {&known, 1});
  return results.faults.empty() ? FaultSeen() : results.faults[0];
}

// What is not drawn does not show that a fault is gone, where it must be among what showed it.
TEST(FaultsSeen, OfCasesThatAreNotDrawnAreNotMissed) {
  using enum Verdict;
  EXPECT_EQ(seen_of({violation, violation}, 1, 3).state, FaultState::known);
  EXPECT_EQ(seen_of({}, 3, 1).id, "") << "none is drawn";
  EXPECT_EQ(seen_of({agree}, 2, 2).id, "") << "one of both that showed it is not drawn";
  // The two that did not show it may be those that are not drawn.
  EXPECT_EQ(seen_of({agree, agree}, 1, 1).state, FaultState::fixed);
  EXPECT_EQ(seen_of({agree, violation}, 1, 2).state, FaultState::shrunk);
  EXPECT_EQ(seen_of({violation, violation}, 1, 1).state, FaultState::grown);
}

TEST(ReasonFrom, WhatWasFound) {
  Results results =
      results_with({Verdict::convention, Verdict::permitted, Verdict::not_run, Verdict::permitted});
  const auto reason = [&](std::size_t i) { return reason_from(results.cases[i].results[0]); };
  results.cases.change(0, [](CaseResults& one) {
    for (Disagreement& d : one.results[0].disagreements) {
      d.cause = cause_named("triangle.fill-rule=left-bottom");
      d.legality = Legality::legal;
    }
  });
  edit(results.cases, 1)->results[0].disagreements.resize(1);
  edit(results.cases, 1)->results[0].disagreements[0].ruling = 4;
  edit(results.cases, 3)->results[0].disagreements.clear();
  edit(results.cases, 3)->results[0].values.resize(1);
  edit(results.cases, 3)->results[0].values[0].attribute = "color";
  EXPECT_EQ(reason(0),
            "2 differences by triangle.fill-rule; it follows triangle.fill-rule=left-bottom");
  EXPECT_EQ(reason(1),
            "one difference by triangle.fill-rule, against ruling 4; no catalogued alternative "
            "draws this");
  EXPECT_EQ(reason(2), "crashed: signal 11");
  EXPECT_EQ(reason(3), "color rounded otherwise than exactly, within what is permitted");
  edit(results.cases, 3)->results[0].values[0].cause = cause_named("texture.log2=mantissa-8");
  EXPECT_EQ(reason(3), "color by texture.log2=mantissa-8");
}

}  // namespace
}  // namespace edgecase
