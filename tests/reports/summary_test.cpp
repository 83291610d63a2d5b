// SPDX-License-Identifier: MIT
#include "reports/summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "reports/explain_command.h"
#include "tests/reports/sample.h"
#include "tests/support/causes.h"
#include "tests/support/edit.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string summary_of(const Results& results, bool color) {
  std::ostringstream out;
  write_summary(results, color, out);
  return out.str();
}

TEST(Summary, TableHasEveryVerdictAndRenderer) {
  const std::string text = summary_of(sample::results(), false);
  for (const char* word : {"violation", "permitted", "convention", "agree", "not-run",
                           "osmesa:llvmpipe", "osmesa:softpipe", "egl:llvmpipe", "egl:softpipe"})
    EXPECT_THAT(text, HasSubstr(word));
  EXPECT_THAT(text, HasSubstr("and "));
}

// `count` cases, each with one result of each of `renderers` renderers, which agrees.
Results agreeing(std::size_t count, std::size_t renderers) {
  Results results;
  results.renderers.resize(renderers);
  CaseResults one;
  one.results.resize(renderers);
  for (Result& result : one.results) result.verdict = Verdict::agree;
  for (std::size_t i = 0; i < count; ++i) results.cases.push_back(one);
  return results;
}

std::string first_line_of(const Results& results, std::optional<RunCost> cost) {
  std::ostringstream out;
  write_summary(results, false, out, cost);
  return out.str().substr(0, out.str().find('\n'));
}

TEST(Summary, TheFirstLineSaysHowTheRunEnded) {
  EXPECT_EQ(first_line_of(agreeing(30718, 2), RunCost{41.4}),
            "30,718 cases, 2 renderers: 0 unexpected, 41 s");
  EXPECT_EQ(first_line_of(agreeing(1, 1), RunCost{0.42}),
            "1 case, 1 renderer: 0 unexpected, 0.4 s");
  EXPECT_EQ(first_line_of(agreeing(3, 1), RunCost{0.1, 1}),
            "3 cases, 1 renderer: 0 unexpected, 1 answer as before, 0.1 s");
  EXPECT_EQ(first_line_of(agreeing(2, 1), {}), "2 cases, 1 renderer: 0 unexpected");
  Results results = agreeing(2, 2);
  results.cases.answer(1, 0).standing = Standing::unexpected;
  results.cases.answer(1, 1).standing = Standing::flake;
  edit(results.cases, 0)->expect_failures = {"drawn", "otherwise"};
  results.diagnostics.resize(1);
  results.faults.resize(3);
  results.faults[1].state = results.faults[2].state = FaultState::grown;
  results.interrupted = true;
  EXPECT_EQ(first_line_of(results, RunCost{9.96}),
            "2 cases, 2 renderers: 2 unexpected, 1 fault in case files, 2 drawings not met, "
            "2 known faults grown, interrupted, 10 s");
}

TEST(Summary, TheSecondLineSaysWhatWasTakenOver) {
  const auto summary = [](std::string note) {
    std::ostringstream out;
    write_summary(agreeing(3, 1), false, out, RunCost{0.1, 1, std::move(note)});
    return out.str();
  };
  EXPECT_NE(summary("of\x1b[1m\nold.zst").find(" 0.1 s\nof\u241b[1m\u240aold.zst\n"),
            std::string::npos)
      << summary("of\x1b[1m\nold.zst");
  EXPECT_NE(summary("").find(" 0.1 s\n\n"), std::string::npos) << summary("");
}

TEST(Summary, TheFirstLineHasTheColourOfTheOutcome) {
  Results results = agreeing(1, 1);
  EXPECT_TRUE(summary_of(results, true).starts_with("\x1b[32m1 case, 1 renderer: 0 unexpected"));
  results.cases.answer(0, 0).standing = Standing::unexpected;
  EXPECT_TRUE(summary_of(results, true).starts_with("\x1b[1m\x1b[31m1 case")) << "bold and red";
  results.cases.answer(0, 0).standing = Standing::expected;
  results.diagnostics.resize(1);
  EXPECT_TRUE(summary_of(results, true).starts_with("\x1b[1m\x1b[31m1 case"));
}

TEST(Summary, NoRowOfZerosAndNoTableOfNoCases) {
  const std::string text = summary_of(agreeing(1234, 1), false);
  EXPECT_THAT(text, HasSubstr("\nagree            1,234\n"));
  for (const char* row : {"\nviolation", "\nnot-run", "\nunexpected"})
    EXPECT_THAT(text, Not(HasSubstr(row)));
  Results none = agreeing(0, 1);
  none.diagnostics = {{"a.json", 1, "", "broken", "mend it"}};
  EXPECT_EQ(summary_of(none, false),
            "0 cases, 1 renderer: 0 unexpected, 1 fault in case files\n\n"
            "Case files that cannot be loaded:\n  a.json:1: broken; mend it\n");
}

TEST(Summary, WithoutColourThereIsNoEscape) {
  EXPECT_THAT(summary_of(sample::results(), false), Not(HasSubstr("\x1b")));
  EXPECT_THAT(summary_of(sample::results(), true), HasSubstr("\x1b["));
}

TEST(Summary, SaysWhatIsMissing) {
  Results results = sample::results();
  results.interrupted = true;
  EXPECT_THAT(summary_of(results, false), HasSubstr("The run was interrupted.\n"));
  results.left_out = 1;
  EXPECT_THAT(summary_of(results, false), HasSubstr("interrupted; 1 case is missing."));
}

TEST(Summary, TellsBothAnswersOfAFlake) {
  Results results = agreeing(1, 1);
  results.renderers[0].name = "exec:./mine";
  edit(results.cases, 0)->id = "a";
  results.cases.answer(0, 0).standing = Standing::flake;
  results.cases.answer(0, 0).standing_reason = "it answered this, and then that";
  EXPECT_THAT(summary_of(results, false),
              HasSubstr("  1 case, exec:./mine: agree, and then another answer\n"
                        "    a: it answered this, and then that\n"));
}

TEST(Summary, TellsWhatTheRunShowsOfKnownFaults) {
  Results results = agreeing(2, 1);
  results.renderers[0].name = "egl:llvmpipe";
  const auto text = [&](FaultState state, std::size_t cases, std::optional<std::size_t> before) {
    results.faults = {{"egl:llvmpipe", "joints", "why", "", cases, before, state}};
    results.cases.answer(0, 0).faults = {"joints"};
    return summary_of(results, false);
  };
  const std::string known = text(FaultState::known, 1, 1);
  EXPECT_THAT(known, HasSubstr("\nKnown: 1 fault of egl:llvmpipe in 1 case.\n"));
  EXPECT_THAT(known, Not(HasSubstr("joints")));
  EXPECT_THAT(text(FaultState::grown, 2, 1),
              HasSubstr("  joints egl:llvmpipe: it has grown: 2 cases, and 1 is known on this "
                        "release\n"));
  EXPECT_THAT(text(FaultState::shrunk, 1, 2), HasSubstr("it has shrunk: 1 case of 2 that"));
  EXPECT_THAT(text(FaultState::fixed, 0, 2), HasSubstr("it is fixed: none of 2 cases\n"));
  EXPECT_THAT(text(FaultState::fixed, 0, {}), HasSubstr("it does not show on this release\n"));
  EXPECT_THAT(text(FaultState::uncounted, 1, {}), HasSubstr("1 case, of a release without a"));
}

TEST(Summary, TellsWhatIsNotSupportedByReason) {
  Results results = agreeing(10, 1);
  results.renderers[0].name = "egl:llvmpipe";
  for (std::size_t i = 0; i < 9; ++i)
    results.cases.answer(i, 0).failure =
        Failure{FailureKind::unsupported, i < 2 ? "no blending" : std::to_string(i)};
  const std::string text = summary_of(results, false);
  EXPECT_THAT(text, HasSubstr("\nNot supported by egl:llvmpipe: 2 cases: no blending.\n"
                              "Not supported by egl:llvmpipe: 1 case: 2.\n"));
  EXPECT_THAT(text, HasSubstr("\nNot supported by egl:llvmpipe: 2 more reasons.\n"));
}

// A case in which one pixel is wrong.
CaseResults wrong_case(const std::string& id, int x, bool legal) {
  CaseResults one;
  one.id = id;
  one.file = "cases/" + id + ".json";
  one.surface = "fbo";
  one.width = one.height = 8;
  one.results.resize(1);
  one.results[0].verdict = legal ? Verdict::convention : Verdict::violation;
  one.results[0].standing = Standing::unexpected;
  one.results[0].disagreements = {sample::disagreement(x, 0, DisagreementKind::extra, legal)};
  return one;
}

TEST(Summary, GroupsWhatIsUnexpectedByCause) {
  Results results;
  results.policy = "opengl";
  results.renderers.resize(1);
  results.renderers[0].name = "exec:./mine";
  for (int i = 0; i < 12; ++i)
    results.cases.push_back(wrong_case("case-" + std::to_string(i), i, false));
  results.cases.push_back(wrong_case("allowed", 3, true));
  CaseResults partly = wrong_case("partly", 3, false);
  partly.results[0].faults = {"joints"};
  results.cases.push_back(partly);
  CaseResults dies = wrong_case("dies", 3, false);
  dies.results[0].disagreements.clear();
  dies.results[0].verdict = Verdict::not_run;
  dies.results[0].failure = Failure{FailureKind::crashed, "exit status 7"};
  results.cases.push_back(dies);
  EXPECT_THAT(summary_of(results, false), HasSubstr(R"(
Unexpected, by cause:
  12 cases, exec:./mine: violation, not known
    line.diamond-exit extra, fbo
    case-0: pixel (0, 0): Pixel (0, 0) differs.
    edgecase explain cases/case-0.json --against exec:./mine --pixel 0,0
  1 case, exec:./mine: violation, known in part
    line.diamond-exit extra, fbo
    partly: pixel (3, 0): Pixel (3, 0) differs.
    edgecase explain cases/partly.json --against exec:./mine --pixel 3,0
  1 case, exec:./mine: not-run, not known
    crashed
    dies: exit status 7
    edgecase explain cases/dies.json --against exec:./mine
  1 case, exec:./mine: convention, not known
    line.diamond-exit extra, fbo
    allowed: pixel (3, 0): Pixel (3, 0) differs.
    edgecase explain cases/allowed.json --against exec:./mine --pixel 3,0

)"));
}

TEST(Summary, TellsAnAnswerByWhatIsNotLegalInIt) {
  Results results;
  results.renderers.resize(1);
  CaseResults one = wrong_case("a", 1, true);
  one.results[0].disagreements.push_back(
      sample::disagreement(5, 0, DisagreementKind::missing, false));
  results.cases.push_back(one);
  EXPECT_THAT(summary_of(results, false),
              HasSubstr("line.diamond-exit missing, fbo\n    a: pixel (5, 0): "));
}

RuleId some_rule(int number) {
  constexpr auto rules = values_of<RuleId>();
  return rules[rules.size() - 1 - static_cast<std::size_t>(number)];
}

TEST(Summary, ListsTenCausesAndTheSimplestCaseOfEach) {
  Results results;
  results.renderers.resize(1);
  for (int i = 0; i < 23; ++i) {
    CaseResults one = wrong_case("case-" + std::to_string(i), 0, false);
    one.results[0].disagreements[0].cause = cause_named(
        "line.snap=" + std::to_string(4 + i % 12 % 6) + (i % 12 < 6 ? "-truncate" : "-half-up"));
    one.results[0].disagreements[0].rule = some_rule(i % 12);
    one.width = 100 - i;
    results.cases.push_back(one);
  }
  const std::string text = summary_of(results, false);
  EXPECT_THAT(text, HasSubstr("  2 cases, : violation, not known\n"
                              "    line.snap=4-truncate, fbo\n    case-12: "));
  EXPECT_THAT(text, HasSubstr("\n  and 2 more causes\n"));
  EXPECT_THAT(text, Not(HasSubstr("case-11: ")));  // the only one of its cause, which comes last
}

// An unexplained cluster with a row of each case, and as many causes, each of a rule of its own.
Results clustered(int count) {
  Results results;
  results.renderers.resize(1);
  results.renderers[0].name = "exec:python3 mine.py";
  results.policy = "opengl";
  for (int i = 0; i < count; ++i) {
    CaseResults one;
    one.id = "lines/a:dx=" + std::to_string(i);
    one.file = "cases/lines/a.json";
    one.surface = "fbo";
    one.results.resize(1);
    Disagreement d = sample::disagreement(i, 1, DisagreementKind::extra, false);
    d.cause = cause_named("line.snap=" + std::to_string(i + 4) + "-truncate");
    const RuleId own = std::exchange(d.rule, some_rule(i));
    one.results[0].disagreements.assign(2, d);
    d.rule = own;
    d.cause = {};
    d.situation = "line, place " + std::to_string(i);
    one.results[0].disagreements.push_back(d);
    results.cases.push_back(one);
  }
  return results;
}

TEST(Summary, ShowsWhatDiffersWithTheCommandThatExplainsIt) {
  const std::string text = summary_of(clustered(1), false);
  EXPECT_THAT(text, HasSubstr(R"(
What differs with exec:python3 mine.py:
  not allowed  line.snap=4-truncate, fbo: 2 in 1 case
               edgecase explain cases/lines/a.json --filter lines/a:dx=0 --against 'exec:python3 mine.py' --pixel 0,1
  not allowed  line.diamond-exit extra, fbo: 1 in 1 case
               edgecase explain cases/lines/a.json --filter lines/a:dx=0 --against 'exec:python3 mine.py' --pixel 0,1
)"));
}

TEST(Summary, ShowsWhatIsNotAllowedThenWhatIsContestedThenWhatIsAllowed) {
  Results results = clustered(3);
  const Legality legalities[] = {Legality::legal, Legality::contested, Legality::illegal};
  for (std::size_t i = 0; i < 3; ++i) {
    CaseResults one = results.cases[i];
    auto& list = one.results[0].disagreements;
    list.pop_back();  // the one without a cause
    for (Disagreement& d : list) d.legality = legalities[i];
    results.cases.replace(i, one);
  }
  const std::string text = summary_of(results, false);
  EXPECT_THAT(text, HasSubstr(R"(
  not allowed  line.snap=6-truncate, fbo: 2 in 1 case
               edgecase explain cases/lines/a.json --filter lines/a:dx=2 --against 'exec:python3 mine.py' --pixel 2,1
  contested    line.snap=5-truncate, fbo: 2 in 1 case
               edgecase explain cases/lines/a.json --filter lines/a:dx=1 --against 'exec:python3 mine.py' --pixel 1,1
  allowed      line.snap=4-truncate, fbo: 2 in 1 case
)"));
}

TEST(Summary, ShowsFiveClustersOfEachLegality) {
  const auto with_contested = [](int count) {
    Results results = clustered(count);
    edit_each(results.cases, [](CaseResults& one) {
      Disagreement& d = one.results[0].disagreements[2];
      d.legality = Legality::contested;
      d.rule = some_rule(d.x);
      d.cause = cause_named("line.snap=" + std::to_string(d.x + 4) + "-half-up");
    });
    return summary_of(results, false);
  };
  const std::string five = with_contested(5);
  EXPECT_THAT(five, HasSubstr("snap=8-half-up,"));
  EXPECT_THAT(five, HasSubstr("snap=8-truncate,"));
  EXPECT_THAT(five, Not(HasSubstr(" more\n")));
  const std::string seven = with_contested(7);
  EXPECT_THAT(seven, Not(HasSubstr("snap=9-half-up,")));
  EXPECT_THAT(seven, Not(HasSubstr("snap=9-truncate,")));
  const std::size_t first = seven.find("  and 2 more\n");
  ASSERT_NE(first, std::string::npos);
  EXPECT_NE(seven.find("  and 2 more\n", first + 1), std::string::npos);
}

TEST(Summary, WhatIsContestedIsCountedAndNotUnexpected) {
  Results results = clustered(1);
  ResultOutline& answer = results.cases.answer(0, 0);
  answer.verdict = Verdict::contested;
  answer.standing = Standing::tolerated;
  EXPECT_THAT(summary_of(results, false), testing::ContainsRegex("contested +1\n"));
  EXPECT_THAT(summary_of(results, false),
              testing::StartsWith("1 case, 1 renderer: 0 unexpected\n"));
  EXPECT_THAT(summary_of(results, false), Not(HasSubstr("Unexpected")));
  answer.standing = Standing::unexpected;
  EXPECT_THAT(summary_of(results, false), HasSubstr("contested, not known\n"));
}

TEST(Summary, UnexpectedOnesAreListedWorstFirst) {
  Results results = clustered(3);
  const Verdict verdicts[] = {Verdict::permitted, Verdict::contested, Verdict::violation};
  for (std::size_t i = 0; i < 3; ++i) {
    results.cases.answer(i, 0).verdict = verdicts[i];
    results.cases.answer(i, 0).standing = Standing::unexpected;
  }
  const std::string text = summary_of(results, false);
  const std::size_t violation = text.find("violation, not known");
  const std::size_t contested = text.find("contested, not known");
  ASSERT_NE(contested, std::string::npos);
  EXPECT_LT(violation, contested);
  EXPECT_LT(contested, text.find("permitted, not known"));
}

TEST(Summary, CommandsNameAPolicyOfTheirOwnAndNoFilterWithoutNeed) {
  Results results = clustered(1);
  results.policy = "vulkan-strict";
  edit(results.cases, 0)->id = "lines/a";
  EXPECT_THAT(summary_of(results, false),
              HasSubstr("edgecase explain cases/lines/a.json --against 'exec:python3 mine.py' "
                        "--pixel 0,1 --policy vulkan-strict\n"));
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_word(""), "''");
}

TEST(Summary, WithoutDifferencesThereAreNoClusters) {
  Results results = clustered(1);
  edit(results.cases, 0)->results[0].disagreements.clear();
  EXPECT_THAT(summary_of(results, false), Not(HasSubstr("What differs")));
}

TEST(Summary, NoTextSteersTheTerminal) {
  Results results;
  results.diagnostics = {{"a\x1b[2J.json", 1, "", "broken\r", ""}};
  const std::string text = summary_of(results, false);
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
  EXPECT_THAT(text, Not(HasSubstr("\r")));
  Results hostile = clustered(1);
  hostile.renderers[0].name = "exec:\x1b[2J";
  edit(hostile.cases, 0)->file = "a\nb\x1b[2J.json";
  edit(hostile.cases, 0)->results[0].disagreements[2].situation = "\x1b[2J";
  EXPECT_THAT(summary_of(hostile, false), Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace edgecase
