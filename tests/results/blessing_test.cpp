// SPDX-License-Identifier: MIT
//
// What blessing would change in a driver's known faults, and nothing else.
#include "results/blessing.h"

#include <gtest/gtest.h>

#include "results/standing.h"
#include "tests/results/sample_results.h"
#include "tests/support/causes.h"
#include "tests/support/edit.h"

namespace edgecase {
namespace {

// Whole results of the release "Fake 2.0".
Results results_of(const std::vector<Verdict>& verdicts) {
  Results results = results_with(verdicts);
  results.renderers[0].version = "Fake 2.0";
  results.whole_suite = true;
  return results;
}

std::vector<FaultChange> plan(Results& results, const KnownFaults& current,
                              const BlessingOptions& options = {}) {
  apply_known_faults(results, {&current, 1});
  return plan_blessing(results, 0, current, options);
}

KnownFaults blessed(Results& results, const KnownFaults& current = {"fake", {}}) {
  return with_changes(current, plan(results, current));
}

TEST(Blessing, MakesOneFaultOfACauseAndOneOfARuleWithoutACause) {
  Results results = results_of({Verdict::violation, Verdict::violation, Verdict::violation,
                                Verdict::convention, Verdict::not_run});
  edit(results.cases, 0)->id = "lines/short:dx=1";
  edit(results.cases, 1)->id = "lines/short:dx=2";
  edit(results.cases, 1)->results[0].disagreements[0].kind = DisagreementKind::extra;
  results.cases.change(2, [](CaseResults& one) {
    std::vector<Disagreement>& listed = one.results[0].disagreements;
    for (Disagreement& d : listed) d.cause = cause_named("triangle.fill-rule=left-bottom");
    listed[1].rule = RuleId::triangle_shared_edge;
  });
  const auto changes = plan(results, {"fake", {}}, {{}, "because", "https://example.org"});
  ASSERT_EQ(changes.size(), 3u);
  for (const FaultChange& change : changes) {
    EXPECT_FALSE(change.before);
    EXPECT_EQ(change.after->reason, "because");
    EXPECT_EQ(change.after->link, "https://example.org");
    EXPECT_EQ(text_of(*change.after->versions), "Fake >=2.0");
  }
  EXPECT_EQ(changes[0].after->id, "triangle.fill-rule") << "that of most cases comes first";
  EXPECT_EQ(changes[0].after->kinds, (std::vector<std::string>{"extra", "missing"}));
  EXPECT_EQ(changes[0].after->cases, std::vector<std::string>{"lines/short"});
  EXPECT_TRUE(changes[0].after->cause->empty());
  EXPECT_EQ(changes[0].after->cases_on.at("Fake 2.0"), 2u);
  EXPECT_EQ(changes[1].after->id, "crashed");
  EXPECT_FALSE(changes[1].after->cause);
  EXPECT_EQ(changes[2].after->id, "triangle.fill-rule=left-bottom");
  EXPECT_EQ(changes[2].after->rules,
            (std::vector{RuleId::triangle_fill_rule, RuleId::triangle_shared_edge}));
  EXPECT_EQ(*changes[2].after->cause, cause_named("triangle.fill-rule=left-bottom"));
}

TEST(Blessing, WhatWasBlessedIsKnown) {
  Results results = results_of({Verdict::agree, Verdict::convention, Verdict::violation,
                                Verdict::not_run, Verdict::violation});
  const KnownFaults known = blessed(results);
  const auto again = parse_known_faults(known_faults_text(known));
  ASSERT_TRUE(std::holds_alternative<KnownFaults>(again)) << std::get<std::string>(again);
  EXPECT_TRUE(plan(results, std::get<KnownFaults>(again)).empty());
  for (const CaseResults& one : results.cases)
    EXPECT_FALSE(is_unexpected(one.results[0].standing)) << one.id;
  for (const FaultSeen& seen : results.faults) EXPECT_EQ(seen.state, FaultState::known);
}

TEST(Blessing, LeavesOutWhatWasNotAskedAndFlakes) {
  Results results = results_of({Verdict::not_run, Verdict::not_run, Verdict::violation});
  results.cases.answer(0, 0).failure = Failure{FailureKind::unsupported, "too large"};
  results.cases.answer(1, 0).failure = Failure{FailureKind::unavailable, "not recorded"};
  results.cases.answer(2, 0).again = Judgement{Verdict::agree, ""};
  EXPECT_TRUE(plan(results, {"fake", {}}).empty());
}

TEST(Blessing, OfSomeCasesLeavesTheOthersOfTheirFile) {
  Results results = results_of({Verdict::violation, Verdict::violation, Verdict::violation});
  edit(results.cases, 0)->id = "lines/short:dx=1";
  edit(results.cases, 1)->id = "lines/short:dx=2";
  edit(results.cases, 2)->id = "lines/long";
  const auto changes =
      plan(results, {"fake", {}},
           {[](const std::string& id) { return id != "lines/short:dx=2"; }, "", ""});
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].after->cases, (std::vector<std::string>{"lines/long", "lines/short:dx=1"}));
}

TEST(Blessing, CountsWhatWholeResultsShow) {
  Results results = results_of({Verdict::violation, Verdict::violation});
  KnownFaults known = blessed(results);
  known.faults[0].cases_on["Fake 2.0"] = 1;
  known.faults[0].cases_on["Fake 1.0"] = 7;
  const auto changes = plan(results, known);
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].after->cases_on,
            (std::map<std::string, std::size_t>{{"Fake 1.0", 7}, {"Fake 2.0", 2}}));
  results.whole_suite = false;
  EXPECT_TRUE(plan(results, known).empty()) << "a part of the suite cannot be counted";
}

TEST(Blessing, ClosesWhatDoesNotShow) {
  Results results = results_of({Verdict::violation});
  KnownFaults known = blessed(results);
  Results fixed = results_of({Verdict::agree});
  auto changes = plan(fixed, known);
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_FALSE(changes[0].after) << "no other release has it";
  EXPECT_TRUE(with_changes(known, changes).faults.empty());

  known.faults[0].versions->low = {1};
  known.faults[0].cases_on["Fake 1.0"] = 3;
  changes = plan(fixed, known);
  ASSERT_EQ(changes.size(), 1u);
  ASSERT_TRUE(changes[0].after) << "an earlier release has it";
  EXPECT_EQ(text_of(*changes[0].after->versions), "Fake >=1 <2.0");
  EXPECT_FALSE(changes[0].after->cases_on.contains("Fake 2.0"));

  fixed.renderers[0] = {"fake", "", "OpenGL ES 3.2 Fake 2.0", "", 8, {}};
  fixed.whole_suite = false;
  EXPECT_TRUE(plan(fixed, known).empty());
}

TEST(Blessing, KeepsTheCountOfWhatIsNotDrawn) {
  Results results = results_of({Verdict::violation, Verdict::violation});
  const KnownFaults known = blessed(results);
  Results partial = results_of({Verdict::violation, Verdict::not_run});
  partial.cases.answer(1, 0).failure = Failure{FailureKind::unsupported, "no samples"};
  EXPECT_TRUE(plan(partial, known).empty());
  partial = results_of({Verdict::not_run, Verdict::not_run});
  for (std::size_t i : {0U, 1U})
    partial.cases.answer(i, 0).failure = Failure{FailureKind::unsupported, "no samples"};
  EXPECT_TRUE(plan(partial, known).empty());
  Results drawn = results_of({Verdict::violation, Verdict::agree});
  EXPECT_EQ(plan(drawn, known).size(), 1u);
}

TEST(Blessing, WidensTheVersionsOfTheSameFault) {
  Results results = results_of({Verdict::violation});
  KnownFaults known = blessed(results);
  const auto release = [&](const char* version) {
    Results other = results;
    other.renderers[0].version = version;
    const auto changes = plan(other, known);
    EXPECT_EQ(changes.size(), 1u);
    EXPECT_TRUE(changes[0].before && changes[0].after);
    return changes[0].after ? *changes[0].after : KnownFault();
  };
  KnownFault earlier = release("Fake 1.5");
  EXPECT_EQ(text_of(*earlier.versions), "Fake >=1.5");
  EXPECT_EQ(earlier.cases_on.size(), 2u);
  known.faults[0].versions->high = {2, 1};
  EXPECT_EQ(text_of(*release("Fake 3.0").versions), "Fake >=2.0");
}

}  // namespace
}  // namespace edgecase
