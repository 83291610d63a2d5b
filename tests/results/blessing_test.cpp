// SPDX-License-Identifier: MIT
//
// What blessing would change: new, changed and gone entries, and nothing else.
#include <gtest/gtest.h>

#include "results/expectations.h"
#include "tests/results/sample_results.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

TEST(PlanBlessing, NamesNewChangedAndGoneEntriesOnly) {
  // a new, b changed in its fingerprint, c gone, d unchanged, e agrees as before, f changed in its
  // verdict; "other" is not among the results, since they were filtered.
  const Results results = results_with({Verdict::violation, Verdict::violation, Verdict::agree,
                                        Verdict::permitted, Verdict::agree, Verdict::not_run});
  Expectations current;
  current.cases = {{"b", {Verdict::violation, "old", "known", "https://example.org/2"}},
                   {"c", {Verdict::violation, "print-c", "was wrong", ""}},
                   {"d", {Verdict::permitted, "print-d", "stays", ""}},
                   {"f", {Verdict::violation, "print-f", "was drawn", ""}},
                   {"other", {Verdict::violation, "print-other", "elsewhere", ""}}};
  const auto changes = plan_blessing(results, 0, current, "because");
  ASSERT_EQ(changes.size(), 4u);

  EXPECT_EQ(changes[0].id, "a");
  EXPECT_EQ(changes[0].before, nullptr);
  ASSERT_TRUE(changes[0].after);
  EXPECT_EQ(changes[0].after->verdict, Verdict::violation);
  EXPECT_EQ(changes[0].after->fingerprint, "print-a");
  EXPECT_EQ(changes[0].after->reason, "because");

  EXPECT_EQ(changes[1].id, "b");
  EXPECT_EQ(changes[1].before, &current.cases.at("b"));
  ASSERT_TRUE(changes[1].after);
  EXPECT_EQ(changes[1].after->fingerprint, "print-b");
  EXPECT_EQ(changes[1].after->link, "https://example.org/2") << "the link of a known fault is kept";

  EXPECT_EQ(changes[2].id, "c");
  EXPECT_EQ(changes[2].before, &current.cases.at("c"));
  EXPECT_FALSE(changes[2].after);

  EXPECT_EQ(changes[3].id, "f");
  ASSERT_TRUE(changes[3].after);
  EXPECT_EQ(changes[3].after->verdict, Verdict::not_run);
}

TEST(PlanBlessing, TakesAwayMissingCasesAndLeavesFlakesAlone) {
  Results results = results_with({Verdict::violation, Verdict::violation});
  results.whole_suite = true;
  results.cases[0].results[0].again = {Verdict::agree, ""};
  Expectations current;
  current.cases = {{"a", {Verdict::permitted, "old", "known", ""}},
                   {"aa", {Verdict::permitted, "gone", "known", ""}}};
  const auto changes = plan_blessing(results, 0, current, "because");
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_EQ(changes[0].id, "aa");
  EXPECT_EQ(changes[0].before, &current.cases.at("aa"));
  EXPECT_FALSE(changes[0].after);
  EXPECT_EQ(changes[1].id, "b");
  EXPECT_TRUE(changes[1].after);
}

TEST(PlanBlessing, MakesAReasonOfWhatWasFound) {
  Results results =
      results_with({Verdict::convention, Verdict::permitted, Verdict::not_run, Verdict::permitted});
  for (Disagreement& d : results.cases[0].results[0].disagreements) {
    d.cause = cause_named("triangle.fill-rule=left-bottom");
    d.legality = Legality::legal;
  }
  results.cases[1].results[0].disagreements.resize(1);
  results.cases[1].results[0].disagreements[0].legality = Legality::illegal;
  results.cases[1].results[0].disagreements[0].ruling = 4;
  results.cases[3].results[0].disagreements.clear();
  results.cases[3].results[0].values.resize(1);
  results.cases[3].results[0].values[0].attribute = "color";
  const auto changes = plan_blessing(results, 0, {}, "");
  ASSERT_EQ(changes.size(), 4u);
  EXPECT_EQ(changes[0].after->reason,
            "2 differences by triangle.fill-rule; it follows triangle.fill-rule=left-bottom");
  EXPECT_EQ(changes[1].after->reason,
            "one difference by triangle.fill-rule, against ruling 4; no catalogued alternative "
            "draws this");
  EXPECT_EQ(changes[2].after->reason, "crashed: signal 11");
  EXPECT_EQ(changes[3].after->reason,
            "color rounded otherwise than exactly, within what is permitted");
  results.cases[3].results[0].values[0].cause = cause_named("texture.log2=mantissa-8");
  EXPECT_EQ(plan_blessing(results, 0, {}, "")[3].after->reason, "color by texture.log2=mantissa-8");
}

// Blessed and read back, the same results are expected; blessing again changes nothing.
// A renderer that could not be asked, as a recording that lacks the case, says nothing of it.
TEST(PlanBlessing, LeavesOutWhatWasNotAsked) {
  Results results = results_with({Verdict::not_run, Verdict::not_run});
  results.cases[0].results[0].failure = Failure{FailureKind::unavailable, "not recorded"};
  results.cases[1].results[0].failure = Failure{FailureKind::unsupported, "too large"};
  const auto changes = plan_blessing(results, 0, {}, "because");
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].id, "b");
}

TEST(PlanBlessing, WhatWasBlessedIsExpected) {
  Results results =
      results_with({Verdict::agree, Verdict::convention, Verdict::violation, Verdict::not_run});
  Expectations expectations;
  expectations.renderer = "fake";
  expectations.cases["a"] = {Verdict::violation, "print-a", "gone", ""};
  for (const ExpectationChange& change : plan_blessing(results, 0, expectations, "")) {
    if (change.after)
      expectations.cases[change.id] = *change.after;
    else
      expectations.cases.erase(change.id);
  }
  const auto outcome = parse_expectations(expectations_text(expectations));
  ASSERT_TRUE(std::holds_alternative<Expectations>(outcome)) << std::get<std::string>(outcome);
  const auto& read = std::get<Expectations>(outcome);
  apply_expectations(results, 0, &read);
  for (const CaseResults& one : results.cases)
    EXPECT_EQ(one.results[0].standing, Standing::expected) << one.id;
  EXPECT_TRUE(plan_blessing(results, 0, read, "again").empty());
}

}  // namespace
}  // namespace edgecase
