// SPDX-License-Identifier: MIT
//
// Decisions hold for what they were made on, and for nothing that came since.
#include "results/decisions.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/results/sample_results.h"

namespace edgecase {
namespace {

std::string file_of(const std::string& decisions) {
  return R"({"edgecase_decisions": 1, "renderer": "fake", "decisions": [)" + decisions + "]}";
}

// A well-formed decision on case a, with more members.
std::string on_a(const std::string& more = "", const std::string& word = "accept") {
  return fmt::format(R"({{"case": "a", "verdict": "violation", "fingerprint": "print-a",
                         "decision": "{}", "reason": "known"{}}})",
                     word, more);
}

std::string refusal(const std::string& text) {
  const auto parsed = parse_decisions(text);
  const auto* fault = std::get_if<std::string>(&parsed);
  return fault != nullptr ? *fault : "";
}

std::vector<Decision> decisions(const std::string& text) {
  auto parsed = parse_decisions(file_of(text));
  if (const auto* fault = std::get_if<std::string>(&parsed)) throw std::runtime_error(*fault);
  return std::get<std::vector<Decision>>(std::move(parsed));
}

TEST(ParseDecisions, ReadsAllMembers) {
  const auto read = decisions(on_a(R"(, "renderer": "other", "link": "https://example.org",
      "expected": {"verdict": "permitted", "fingerprint": "old"})"));
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].id, "a");
  EXPECT_EQ(read[0].renderer, "other");
  EXPECT_EQ(read[0].seen, (Judgement{Verdict::violation, "print-a"}));
  EXPECT_EQ(read[0].expected, (Judgement{Verdict::permitted, "old"}));
  EXPECT_TRUE(read[0].accepts);
  EXPECT_EQ(read[0].reason, "known");
  EXPECT_EQ(read[0].link, "https://example.org");
  const auto plain = decisions(on_a(R"(, "expected": null)", "reject"));
  EXPECT_EQ(plain[0].renderer, "fake");
  EXPECT_FALSE(plain[0].expected);
  EXPECT_FALSE(plain[0].accepts);
}

TEST(ParseDecisions, RefusesWithThePlace) {
  const auto replaced = [](std::string from, const std::string& to) {
    std::string text = on_a();
    return text.replace(text.find(from), from.size(), to);
  };
  const std::pair<std::string, const char*> faults[] = {
      {"", "the file"},
      {"[]", "no object"},
      {R"({"edgecase_decisions": 2, "decisions": []})", "\"edgecase_decisions\" must be 1"},
      {R"({"edgecase_decisions": 1})", "\"decisions\" is no list"},
      {R"({"edgecase_decisions": 1, "decisions": [], "more": 1})", "unknown key \"more\""},
      {R"({"edgecase_decisions": 1, "decisions": [)" + on_a() + "]}",
       "/decisions/0 (case a): \"renderer\" is missing"},
      {file_of(on_a() + "," + on_a("", "reject")), "/decisions/1 (case a): /decisions/0 is on"},
      {file_of(on_a(R"(, "note": "x")")), "/decisions/0 (case a): unknown key \"note\""},
      {file_of(on_a("", "perhaps")), "\"perhaps\" is no decision"},
      {file_of(replaced(R"("reason": "known")", R"("reason": "")")), "\"reason\" is empty"},
      {file_of(replaced(R"(, "reason": "known")", "")), "\"reason\" is missing"},
      {file_of(replaced("violation", "fine")), "\"fine\" is no verdict"},
      {file_of(replaced(R"("fingerprint": "print-a",)", "")), "\"fingerprint\" is missing"},
      {file_of(replaced(R"("case": "a")", R"("case": 7)")), "/decisions/0: \"case\" is no text"},
      {file_of(on_a(R"(, "expected": {"verdict": "agree"})")), "\"fingerprint\" is missing"},
      {file_of("7"), "/decisions/0: this is no object"},
  };
  for (const auto& [text, said] : faults)
    EXPECT_NE(refusal(text).find(said), std::string::npos) << text << "\n" << refusal(text);
}

// One decision on the results' case a, whose answer is violation print-a.
struct Trial {
  Results results = results_with({Verdict::violation, Verdict::agree});
  Expectations current;
  std::vector<Decision> list;

  DecisionOutcome outcome(const std::string& text) {
    list = decisions(text);
    const auto outcomes = apply_decisions(results, 0, current, list);
    EXPECT_EQ(outcomes.size(), 1u);
    return outcomes.front();
  }
  void expect_of_a(Verdict verdict, const std::string& fingerprint) {
    current.cases["a"] = {verdict, fingerprint, "before", "https://example.org/1"};
  }
};

constexpr const char* kSawOld = R"(, "expected": {"verdict": "permitted", "fingerprint": "old"})";
constexpr const char* kSawSame =
    R"(, "expected": {"verdict": "violation", "fingerprint": "print-a"})";

TEST(ApplyDecisions, AcceptedAnswersBecomeEntries) {
  Trial trial;
  const auto fresh = trial.outcome(on_a());
  EXPECT_EQ(fresh.refusal, "");
  ASSERT_TRUE(fresh.change && fresh.change->after);
  EXPECT_EQ(fresh.change->before, nullptr);
  EXPECT_EQ(fresh.change->after->fingerprint, "print-a");
  EXPECT_EQ(fresh.change->after->reason, "known");

  trial.expect_of_a(Verdict::permitted, "old");
  const auto changed = trial.outcome(on_a(kSawOld));
  ASSERT_TRUE(changed.change && changed.change->after);
  EXPECT_EQ(changed.change->before, &trial.current.cases.at("a"));
  EXPECT_EQ(changed.change->after->link, "https://example.org/1") << "a link that is known is kept";
}

TEST(ApplyDecisions, AcceptedAgreementTakesTheEntryAway) {
  Trial trial;
  const std::string on_b =
      R"({"case": "b", "verdict": "agree", "fingerprint": "", "decision": "accept",
          "reason": "fixed", "expected": {"verdict": "permitted", "fingerprint": "old"}})";
  trial.current.cases["b"] = {Verdict::permitted, "old", "before", ""};
  const auto outcome = trial.outcome(on_b);
  ASSERT_TRUE(outcome.change);
  EXPECT_FALSE(outcome.change->after);
  trial.current.cases.clear();
  const auto done = trial.outcome(on_b);
  EXPECT_EQ(done.refusal, "") << "what is done already is not refused";
  EXPECT_FALSE(done.change);
}

TEST(ApplyDecisions, RejectionWritesNothingAndTakesAwayOnlyWhatItRejects) {
  Trial trial;
  EXPECT_FALSE(trial.outcome(on_a("", "reject")).change);
  EXPECT_EQ(trial.outcome(on_a("", "reject")).refusal, "");
  trial.expect_of_a(Verdict::permitted, "old");
  EXPECT_FALSE(trial.outcome(on_a(kSawOld, "reject")).change) << "another entry stays";
  trial.expect_of_a(Verdict::violation, "print-a");
  const auto gone = trial.outcome(on_a(kSawSame, "reject"));
  ASSERT_TRUE(gone.change);
  EXPECT_FALSE(gone.change->after);
}

TEST(ApplyDecisions, WhatHasChangedSinceIsRefused) {
  const auto refused = [](Trial& trial, const std::string& text, const std::string& said) {
    const auto outcome = trial.outcome(text);
    EXPECT_FALSE(outcome.change);
    EXPECT_NE(outcome.refusal.find(said), std::string::npos) << outcome.refusal;
  };
  Trial trial;
  refused(trial, on_a(kSawOld), "when permitted old was expected, and now nothing is");
  trial.expect_of_a(Verdict::permitted, "newer");
  refused(trial, on_a(kSawOld), "and now permitted newer is");
  refused(trial, on_a(), "when nothing was expected");
  trial.expect_of_a(Verdict::violation, "print-a");
  refused(trial, on_a("", "reject"), "when nothing was expected");

  Trial answers;
  answers.results.cases[0].results[0].fingerprint = "print-z";
  refused(answers, on_a(),
          "it was made on violation print-a, and the results have violation print-z");
  answers.results.cases[0].results[0].fingerprint = "print-a";
  answers.results.cases[0].results[0].verdict = Verdict::permitted;
  refused(answers, on_a(), "the results have permitted print-a");
  Trial flake;
  flake.results.cases[0].results[0].again = {Verdict::agree, ""};
  refused(flake, on_a(), "changes when it is asked for again");
  Trial gone;
  gone.results.cases.erase(gone.results.cases.begin());
  refused(gone, on_a(), "no such case");
}

TEST(ApplyDecisions, OnOtherRenderersAreLeftToThem) {
  Trial trial;
  trial.list = decisions(on_a(R"(, "renderer": "other")"));
  EXPECT_TRUE(apply_decisions(trial.results, 0, trial.current, trial.list).empty());
}

}  // namespace
}  // namespace edgecase
