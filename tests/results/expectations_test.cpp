// SPDX-License-Identifier: MIT
#include "results/expectations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/results/missing_case.h"
#include "tests/results/sample_results.h"

namespace edgecase {
namespace {

using ::testing::StartsWith;

Expectations some_expectations() {
  Expectations expectations;
  expectations.renderer = "fake";
  expectations.measured = "llvmpipe \"15\", 4.5 é";
  expectations.cases = {
      {"b", {Verdict::violation, "print-b", "it draws too much", "https://example.org/1"}},
      {"a", {Verdict::convention, "0123", "left\nbottom \"tie\"", ""}},
      {"c", {Verdict::not_run, "crashed", "signal 11", ""}}};
  return expectations;
}

std::string refusal(const std::string& text) {
  const auto outcome = parse_expectations(text);
  const auto* error = std::get_if<std::string>(&outcome);
  return error != nullptr ? *error : "";
}

TEST(Expectations, TextReadsBack) {
  const Expectations expectations = some_expectations();
  const std::string text = expectations_text(expectations);
  const auto outcome = parse_expectations(text);
  ASSERT_TRUE(std::holds_alternative<Expectations>(outcome)) << std::get<std::string>(outcome);
  const auto& back = std::get<Expectations>(outcome);
  EXPECT_EQ(back.renderer, expectations.renderer);
  EXPECT_EQ(back.measured, expectations.measured);
  ASSERT_EQ(back.cases.size(), expectations.cases.size());
  for (const auto& [id, entry] : expectations.cases) {
    const Expectation& other = back.cases.at(id);
    EXPECT_EQ(std::tie(entry.verdict, entry.fingerprint, entry.reason, entry.link),
              std::tie(other.verdict, other.fingerprint, other.reason, other.link));
  }
  EXPECT_EQ(expectations_text(back), text);
}

TEST(Expectations, TextHasOneSortedEntryPerLine) {
  const std::string text = expectations_text(some_expectations());
  const std::size_t a = text.find("\n    {\"case\":\"a\""), b = text.find("\n    {\"case\":\"b\"");
  ASSERT_NE(a, std::string::npos);
  EXPECT_LT(a, b);
  EXPECT_EQ(expectations_text({}).find("case"), std::string::npos);
  EXPECT_EQ(refusal(expectations_text({"r", "m", {}})), "");
}

// What follows the name of a renderer that nobody asks about is not even looked at.
TEST(Expectations, OfARendererThatIsNotWantedAreLeftOut) {
  const auto none = [](const std::string& name) { return name != "fake"; };
  const auto read = [&](const std::string& text, const WantedRenderer& wanted) {
    const auto outcome = parse_expectations(text, wanted);
    EXPECT_TRUE(std::holds_alternative<Expectations>(outcome)) << std::get<std::string>(outcome);
    return std::get<Expectations>(outcome);
  };
  const std::string text = expectations_text(some_expectations());
  EXPECT_EQ(read(text, none).renderer, "fake");
  EXPECT_TRUE(read(text, none).cases.empty());
  EXPECT_EQ(read(text, [](const std::string& name) { return name == "fake"; }).cases.size(), 3u);
  const std::string renderer = "\"renderer\": \"fake\"";
  EXPECT_TRUE(read("{" + renderer + ", broken", none).cases.empty());
  const std::string entry =
      R"({"case": "a", "verdict": "violation", "fingerprint": "", "reason": "r"})";
  EXPECT_TRUE(read("{\"expectations\": [" + entry + "], " + renderer + "}", none).cases.empty());
}

// Of lists within lists, and of objects that are no list, nothing is taken for an entry.
TEST(Expectations, AreEntriesOfOneListAlone) {
  const std::string head = R"({"renderer": "r", "measured": "m", "expectations": )";
  const std::string entry =
      R"({"case": "a", "verdict": "violation", "fingerprint": "", "reason": "r"})";
  EXPECT_EQ(refusal(head + "[" + entry + "]}"), "");
  EXPECT_EQ(refusal(head + "{\"a\": " + entry + "}}"), "the file: \"expectations\" is no list");
  EXPECT_NE(refusal(head + "[[" + entry + "]]}"), "");
  EXPECT_NE(refusal(head + "[7]}"), "");
  EXPECT_NE(refusal(head + "[" + entry + "," + entry + "]}").find("two entries"),
            std::string::npos);
  EXPECT_EQ(refusal(R"({"renderer": "r", "measured": "m", "more": [)" + entry + "]}"),
            "the file: unknown key \"more\"");
}

TEST(Expectations, TextOfInvalidUtf8IsStillWritten) {
  Expectations expectations = some_expectations();
  expectations.renderer = "exec:\xff";
  expectations.measured = "\xc3";
  expectations.cases["a"].reason = "\xed\xa0\x80";
  EXPECT_EQ(refusal(expectations_text(expectations)), "");
}

TEST(Expectations, FileNamesHoldNoSeparators) {
  EXPECT_EQ(expectations_file_name("osmesa:llvmpipe"), "osmesa-llvmpipe.json");
  EXPECT_EQ(expectations_file_name("exec:../a b"), "exec-..-a-b.json");
  const std::string longest(200, 'x');
  EXPECT_EQ(expectations_file_name(longest), longest + ".json");
  const std::string one = expectations_file_name(longest + "/one");
  EXPECT_THAT(one, StartsWith(longest + "-"));
  EXPECT_LT(one.size(), 255u);
  EXPECT_NE(one, expectations_file_name(longest + "/two"));
}

std::string file_with(const std::string& entries) {
  return R"({"renderer": "r", "measured": "m", "expectations": [)" + entries + "]}";
}

TEST(Expectations, BadFilesAreRefusedWithTheirCase) {
  const std::string good = R"({"case":"a","verdict":"violation","fingerprint":"1","reason":"so"})";
  ASSERT_EQ(refusal(file_with(good)), "");
  const std::pair<std::string, std::string> bad[] = {
      {good + "," + good, "expectation of a: the case has two entries"},
      {R"({"case":"a","verdict":"violation","fingerprint":"1","reason":""})", "needs a reason"},
      {R"({"case":"a","verdict":"violation","fingerprint":"1"})", "reason"},
      {R"({"case":"a","verdict":"fine","fingerprint":"1","reason":"so"})",
       "\"fine\" is no verdict"},
      {R"({"case":"a","verdict":"violation","fingerprint":"1","reason":"so","skip":true})",
       "unknown key \"skip\""},
      {R"({"case":"a","verdict":"violation","fingerprint":1,"reason":"so"})", "expectation of a"},
      {R"({"verdict":"violation","fingerprint":"1","reason":"so"})", "expectation 0"},
      {good + ",7", "expectation 1"},
  };
  for (const auto& [entries, said] : bad)
    EXPECT_NE(refusal(file_with(entries)).find(said), std::string::npos)
        << refusal(file_with(entries));
}

TEST(Expectations, FilesOfAnotherShapeAreRefused) {
  for (const char* text :
       {"", "[]", "{}", "{\"renderer\":\"r\"}", "nonsense", R"({"renderer":"r","measured":"m"})",
        R"({"renderer":"r","measured":"m","expectations":{}})",
        R"({"renderer":"r","measured":"m","expectations":7})",
        R"({"renderer":"r","measured":"m","expectations":[],"allow":3})"})
    EXPECT_NE(refusal(text), "") << text;
}

// For every verdict: without an entry, with the same answer, with another fingerprint, with another
// verdict.
TEST(Standing, OfAllCombinations) {
  const Verdict differing[] = {Verdict::convention, Verdict::permitted, Verdict::violation,
                               Verdict::not_run};
  for (Verdict verdict : differing) {
    Results results = results_with({verdict});
    const Result& result = results.cases[0].results[0];
    const auto standing_with = [&](const Expectation& entry) {
      Expectations expectations;
      expectations.cases["a"] = entry;
      apply_expectations(results, 0, &expectations);
      return result.standing;
    };
    apply_expectations(results, 0, nullptr);
    EXPECT_EQ(result.standing, Standing::unexpected);
    EXPECT_FALSE(result.expectation.empty());
    const Expectations none;
    apply_expectations(results, 0, &none);
    EXPECT_EQ(result.standing, Standing::unexpected);
    EXPECT_EQ(standing_with({verdict, "print-a", "known", ""}), Standing::expected);
    EXPECT_EQ(result.expectation, "known");
    EXPECT_EQ(standing_with({verdict, "other", "known", ""}), Standing::changed);
    EXPECT_NE(result.expectation.find("known"), std::string::npos);
    // Which of the two legal verdicts it is depends on the other cases of the run.
    const auto kind_of = [](Verdict v) { return v == Verdict::convention ? Verdict::permitted : v; };
    for (Verdict other : differing) {
      const Standing expected =
          kind_of(other) == kind_of(verdict) ? Standing::expected : Standing::changed;
      EXPECT_EQ(standing_with({other, "print-a", "known", ""}), expected);
    }
  }
}

// What is contested is told and not red, whatever else was expected; with --strict it is as red as
// any other difference.
TEST(Standing, OfWhatIsContested) {
  Results results = results_with({Verdict::contested});
  const Result& result = results.cases[0].results[0];
  const auto standings_with = [&](const Expectations* expectations) {
    apply_expectations(results, 0, expectations);
    const Standing by_default = result.standing;
    EXPECT_EQ(is_unexpected(by_default), false);
    hold_contested(results);
    return std::pair(by_default, result.standing);
  };
  EXPECT_EQ(standings_with(nullptr), std::pair(Standing::tolerated, Standing::unexpected));
  EXPECT_FALSE(result.expectation.empty());
  Expectations expectations;
  expectations.cases["a"] = {Verdict::contested, "print-a", "known", ""};
  EXPECT_EQ(standings_with(&expectations), std::pair(Standing::expected, Standing::expected));
  EXPECT_EQ(result.expectation, "known");
  expectations.cases["a"] = {Verdict::contested, "other", "known", ""};
  EXPECT_EQ(standings_with(&expectations), std::pair(Standing::tolerated, Standing::changed));
  expectations.cases["a"] = {Verdict::violation, "print-a", "known", ""};
  EXPECT_EQ(standings_with(&expectations), std::pair(Standing::tolerated, Standing::changed));
  EXPECT_NE(result.expectation.find("expected violation print-a (known)"), std::string::npos);
}

TEST(Standing, OfAViolationWhereSomethingContestedWasExpected) {
  Results results = results_with({Verdict::violation});
  Expectations expectations;
  expectations.cases["a"] = {Verdict::contested, "print-a", "known", ""};
  apply_expectations(results, 0, &expectations);
  EXPECT_EQ(results.cases[0].results[0].standing, Standing::changed);
}

TEST(Standing, AContestedFlakeIsAFlake) {
  Results results = results_with({Verdict::contested});
  results.cases[0].results[0].again = Judgement{Verdict::agree, ""};
  apply_expectations(results, 0, nullptr);
  EXPECT_EQ(results.cases[0].results[0].standing, Standing::flake);
}

TEST(Standing, OfAgreement) {
  Results results = results_with({Verdict::agree});
  const Result& result = results.cases[0].results[0];
  apply_expectations(results, 0, nullptr);
  EXPECT_EQ(result.standing, Standing::expected);
  EXPECT_TRUE(result.expectation.empty());
  for (Verdict verdict :
       {Verdict::convention, Verdict::permitted, Verdict::violation, Verdict::not_run}) {
    Expectations expectations;
    expectations.cases["a"] = {verdict, "print-a", "known", ""};
    apply_expectations(results, 0, &expectations);
    EXPECT_EQ(result.standing, Standing::unexpected_agreement);
    EXPECT_NE(result.expectation.find("known"), std::string::npos);
  }
}

// Neither of the two answers can be what is expected.
TEST(Standing, OfAFlakeWhateverIsExpected) {
  for (const Judgement& again : {Judgement{Verdict::agree, ""}, {Verdict::permitted, "print-a"}}) {
    Results results = results_with({Verdict::violation});
    KnownResult& result = results.cases[0].results[0];
    result.again = again;
    apply_expectations(results, 0, nullptr);
    EXPECT_EQ(result.standing, Standing::flake);
    EXPECT_FALSE(result.expected);
    for (const Judgement& known : {Judgement{Verdict::violation, "print-a"}, again}) {
      Expectations expectations;
      expectations.cases["a"] = {known.verdict, known.fingerprint, "known", ""};
      apply_expectations(results, 0, &expectations);
      EXPECT_EQ(result.standing, Standing::flake);
      EXPECT_EQ(result.expected, known);
      EXPECT_NE(result.expectation.find("violation print-a"), std::string::npos);
      EXPECT_NE(result.expectation.find(name_of(again.verdict)), std::string::npos);
    }
  }
}

TEST(MissingCases, AreKnownOfWholeResultsOnly) {
  Results results = results_with({Verdict::agree, Verdict::violation});
  results.whole_suite = true;
  Expectations expectations;
  expectations.renderer = "fake";
  expectations.cases = {{"a", {Verdict::violation, "p", "now agrees", ""}},
                        {"gone", {Verdict::permitted, "q", "was so", ""}}};
  const MissingCase gone = missing_case("fake", "gone", {Verdict::permitted, "q"}, "was so");
  EXPECT_EQ(missing_cases(results, expectations), std::vector{gone});

  const auto spoil = [&](auto change) {
    Results other = results;
    change(other);
    EXPECT_TRUE(missing_cases(other, expectations).empty());
  };
  spoil([](Results& r) { r.whole_suite = false; });
  spoil([](Results& r) { r.shard = {0, 2, 4, ""}; });
  spoil([](Results& r) { r.interrupted = true; });
  spoil([](Results& r) { r.diagnostics.resize(1); });
}

TEST(Standing, IsSetForTheRendererAskedForOnly) {
  Results results = results_with({Verdict::violation});
  results.renderers.push_back({});
  results.cases[0].results.push_back(results.cases[0].results[0]);
  apply_expectations(results, 1, nullptr);
  EXPECT_EQ(results.cases[0].results[0].standing, Standing::expected);
  EXPECT_EQ(results.cases[0].results[1].standing, Standing::unexpected);
}

}  // namespace
}  // namespace edgecase
