// SPDX-License-Identifier: MIT
//
// Decisions hold for what they were made on, and for nothing that came since.
#include "results/decisions.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "results/standing.h"
#include "tests/results/sample_results.h"

namespace edgecase {
namespace {

std::string file_of(const std::string& decisions) {
  return R"({"edgecase_decisions": 2, "renderer": "fake", "decisions": [)" + decisions + "]}";
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
  const auto read = decisions(on_a(R"(, "renderer": "other", "link": "https://example.org")"));
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].id, "a");
  EXPECT_EQ(read[0].renderer, "other");
  EXPECT_EQ(read[0].seen, (Judgement{Verdict::violation, "print-a"}));
  EXPECT_TRUE(read[0].accepts);
  EXPECT_EQ(read[0].reason, "known");
  EXPECT_EQ(read[0].link, "https://example.org");
  const auto plain = decisions(on_a("", "reject"));
  EXPECT_EQ(plain[0].renderer, "fake");
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
      {R"({"edgecase_decisions": 1, "decisions": []})", "\"edgecase_decisions\" must be 2"},
      {R"({"edgecase_decisions": 2})", "\"decisions\" is no list"},
      {R"({"edgecase_decisions": 2, "decisions": [], "more": 1})", "unknown key \"more\""},
      {R"({"edgecase_decisions": 2, "decisions": [)" + on_a() + "]}",
       "/decisions/0 (case a): \"renderer\" is missing"},
      {file_of(on_a() + "," + on_a("", "reject")), "/decisions/1 (case a): /decisions/0 is on"},
      {file_of(on_a(R"(, "note": "x")")), "/decisions/0 (case a): unknown key \"note\""},
      {file_of(on_a("", "perhaps")), "\"perhaps\" is no decision"},
      {file_of(replaced(R"("reason": "known")", R"("reason": "")")), "\"reason\" is empty"},
      {file_of(replaced(R"(, "reason": "known")", "")), "\"reason\" is missing"},
      {file_of(replaced("violation", "fine")), "\"fine\" is no verdict"},
      {file_of(replaced(R"("fingerprint": "print-a",)", "")), "\"fingerprint\" is missing"},
      {file_of(replaced(R"("case": "a")", R"("case": 7)")), "/decisions/0: \"case\" is no text"},
      {file_of(on_a(R"(, "expected": null)")), "unknown key \"expected\""},
      {file_of("7"), "/decisions/0: this is no object"},
  };
  for (const auto& [text, said] : faults)
    EXPECT_NE(refusal(text).find(said), std::string::npos) << text << "\n" << refusal(text);
}

// One decision on the results' case a, whose answer is violation print-a.
struct Trial {
  Results results = results_with({Verdict::violation, Verdict::agree, Verdict::violation});
  KnownFaults known{"fake", {}};
  std::vector<Decision> list;

  DecisionOutcome outcome(const std::string& text) {
    list = decisions(text);
    apply_known_faults(results, {&known, 1});
    const auto outcomes = weigh_decisions(results, 0, list);
    EXPECT_EQ(outcomes.size(), 1u);
    return outcomes.front();
  }
  std::vector<FaultChange> changes(const std::string& text) {
    list = decisions(text);
    apply_known_faults(results, {&known, 1});
    return plan_decisions(results, 0, known, weigh_decisions(results, 0, list));
  }
};

TEST(Decisions, AcceptedAnswersBecomeKnown) {
  Trial trial;
  EXPECT_EQ(trial.outcome(on_a()).refusal, "");
  const auto changes = trial.changes(on_a(R"(, "link": "https://example.org/1")"));
  ASSERT_EQ(changes.size(), 1u);
  ASSERT_TRUE(changes[0].after);
  EXPECT_EQ(changes[0].after->reason, "known");
  EXPECT_EQ(changes[0].after->link, "https://example.org/1");
  EXPECT_EQ(changes[0].after->cases, std::vector<std::string>{"a"});
  trial.known = with_changes(trial.known, changes);
  apply_known_faults(trial.results, {&trial.known, 1});
  EXPECT_EQ(trial.results.cases[0].results[0].standing, Standing::known);
  EXPECT_EQ(trial.results.cases[2].results[0].standing, Standing::unexpected);
  EXPECT_EQ(trial.outcome(on_a()).refusal, "it is known by now: triangle.fill-rule");
}

// One reason is one fault, whatever the number of decisions.
TEST(Decisions, ForOneReasonBecomeOneFault) {
  Trial trial;
  const std::string on_c =
      R"({"case": "c", "verdict": "violation", "fingerprint": "print-c",
          "decision": "accept", "reason": ")";
  EXPECT_EQ(trial.changes(on_a() + "," + on_c + "known\"}").size(), 1u);
  const auto two = trial.changes(on_a() + "," + on_c + "another\"}");
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].after->id, "triangle.fill-rule");
  EXPECT_EQ(two[1].after->id, "triangle.fill-rule-2");
}

TEST(Decisions, RejectionWritesNothing) {
  Trial trial;
  EXPECT_EQ(trial.outcome(on_a("", "reject")).refusal, "");
  EXPECT_TRUE(trial.changes(on_a("", "reject")).empty());
}

TEST(Decisions, OnWhatHasChangedSinceAreRefused) {
  const auto refused = [](Trial& trial, const std::string& text, const std::string& said) {
    EXPECT_NE(trial.outcome(text).refusal.find(said), std::string::npos)
        << trial.outcome(text).refusal;
    EXPECT_TRUE(trial.changes(text).empty());
  };
  Trial answers;
  answers.results.cases.answer(0, 0).fingerprint = "print-z";
  refused(answers, on_a(),
          "it was made on violation print-a, and the results have violation print-z");
  answers.results.cases.answer(0, 0).fingerprint = "print-a";
  answers.results.cases.answer(0, 0).verdict = Verdict::permitted;
  refused(answers, on_a(), "the results have permitted print-a");
  Trial legal;
  refused(legal,
          R"({"case": "b", "verdict": "agree", "fingerprint": "", "decision": "accept",
              "reason": "fixed"})",
          "a result that is expected needs no known fault");
  Trial flake;
  flake.results.cases.answer(0, 0).again = {Verdict::agree, ""};
  refused(flake, on_a(), "changes when it is asked for again");
  Trial gone;
  gone.results.cases.erase_if([](const CaseOutline& one) { return one.id == "a"; });
  refused(gone, on_a(), "no such case");
}

TEST(Decisions, OnOtherRenderersAreLeftToThem) {
  Trial trial;
  trial.list = decisions(on_a(R"(, "renderer": "other")"));
  EXPECT_TRUE(weigh_decisions(trial.results, 0, trial.list).empty());
}

}  // namespace
}  // namespace edgecase
