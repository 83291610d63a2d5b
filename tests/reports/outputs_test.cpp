// SPDX-License-Identifier: MIT
//
// What the writers for CI make of results: CTRF, CSV, annotations, Markdown. Parsers of other
// people's read them in tests/tools/outputs_test.py.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>
#include <string>

#include "reports/annotations.h"
#include "reports/ctrf.h"
#include "reports/disagreements_csv.h"
#include "reports/junit.h"
#include "reports/markdown.h"
#include "reports/summary_markdown.h"
#include "reports/test_outcomes.h"
#include "reports/text.h"
#include "tests/reports/large_run.h"
#include "tests/reports/sample.h"
#include "tests/support/edit.h"

namespace edgecase {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

template <class Write>
std::string text_of(const Write& write) {
  std::ostringstream out;
  write(out);
  return out.str();
}

std::string junit_of(const Results& results) {
  return text_of([&](std::ostream& out) { write_junit(results, {}, out); });
}

std::string ctrf_of(const Results& results) {
  return text_of([&](std::ostream& out) { write_ctrf(results, {}, out); });
}

std::string csv_of(const Results& results) {
  return text_of([&](std::ostream& out) { write_disagreements_csv(results, out); });
}

std::string markdown_of(const Results& results) {
  return text_of([&](std::ostream& out) { write_markdown_summary(results, out); });
}

std::string annotations_of(const Results& results) {
  const PathInRepository same = [](const std::string& file) { return file; };
  return text_of([&](std::ostream& out) { write_annotations(results, same, out); });
}

std::size_t lines_in(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

// One renderer, one case, one disagreement, unexpected.
Results single() {
  Results results = sample::large_run(1, 1);
  results.cases.change(0, [](CaseResults& one) {
    one.id = "lines/tip";
    one.file = "cases/lines/tip.json";
    one.results[0].disagreements[0].explanation = "It differs.";
  });
  return results;
}

TEST(Outcomes, ASuiteNamedTwiceAndATestNamedTwiceAreNumbered) {
  Results results = single();
  results.renderers.push_back(results.renderers[0]);
  edit(results.cases, 0)->results.push_back(results.cases[0].results[0]);
  results.cases.push_back(results.cases[0]);
  std::vector<std::string> names;
  visit_outcomes(results, [&names](const TestOutcome& outcome) {
    names.push_back(outcome.suite.front() + " " + outcome.name);
  });
  EXPECT_THAT(names,
              ElementsAre("osmesa:softpipe lines/tip", "osmesa:softpipe lines/tip (2)",
                          "osmesa:softpipe (2) lines/tip", "osmesa:softpipe (2) lines/tip (2)"));
}

// A violation, something contested that is tolerated, and something permitted, in the order in
// which they must not be told.
Results side_by_side(Standing of_contested) {
  Results results = sample::large_run(3, 1);
  const Verdict verdicts[] = {Verdict::permitted, Verdict::contested, Verdict::violation};
  const Legality legalities[] = {Legality::legal, Legality::contested, Legality::illegal};
  for (std::size_t i = 0; i < 3; ++i) {
    CaseResults one = results.cases[i];
    one.id = fmt::format("lines/{}", name_of(verdicts[i]));
    one.file = "cases/" + one.id + ".json";
    Result& result = one.results[0];
    result.verdict = verdicts[i];
    result.standing = verdicts[i] == Verdict::contested ? of_contested : Standing::unexpected;
    result.disagreements[0].legality = legalities[i];
    result.disagreements[0].explanation = fmt::format("It is {}.", name_of(verdicts[i]));
    results.cases.replace(i, one);
  }
  return results;
}

TEST(Outcomes, WhatIsContestedPassesWithAMessageAndFailsWhereItIsHeld) {
  for (const bool is_held : {false, true}) {
    std::vector<std::string> names;
    visit_outcomes(side_by_side(is_held ? Standing::unexpected : Standing::tolerated),
                   [&](const TestOutcome& outcome) {
                     names.push_back(outcome.name);
                     if (outcome.name != "lines/contested") return;
                     EXPECT_EQ(outcome.status, is_held ? TestStatus::failed : TestStatus::passed);
                     EXPECT_THAT(outcome.message, StartsWith("contested, "));
                     if (is_held) return;
                     EXPECT_THAT(outcome.message, HasSubstr("It is contested."));
                   });
    EXPECT_THAT(names, ElementsAre("lines/violation", "lines/contested", "lines/permitted"));
  }
}

TEST(Outcomes, DetailsTellWhatIsNotAllowedFirst) {
  Results results = single();
  const Legality legalities[] = {Legality::legal, Legality::contested, Legality::illegal};
  results.cases.change(0, [&](CaseResults& one) {
    auto& list = one.results[0].disagreements;
    list.resize(3, list[0]);
    for (std::size_t i = 0; i < 3; ++i) {
      list[i].x = static_cast<int>(i);
      list[i].legality = legalities[i];
    }
  });
  visit_outcomes(results, [](const TestOutcome& outcome) {
    const std::size_t illegal = outcome.details.find("pixel (2, 0)");
    const std::size_t contested = outcome.details.find("pixel (1, 0)");
    EXPECT_LT(illegal, contested);
    EXPECT_LT(contested, outcome.details.find("pixel (0, 0)"));
    EXPECT_THAT(outcome.details, HasSubstr(", contested by ruling"));
    EXPECT_THAT(outcome.details, HasSubstr("--pixel 2,0\n"));
  });
}

TEST(Junit, WhatIsContestedIsSaidByATestThatPasses) {
  pugi::xml_document junit;
  junit.load_string(junit_of(side_by_side(Standing::tolerated)).c_str());
  const pugi::xml_node suite = junit.child("testsuites").child("testsuite");
  EXPECT_EQ(suite.attribute("failures").as_int(), 2);
  const pugi::xml_node first = suite.child("testcase");
  EXPECT_STREQ(first.attribute("name").value(), "lines/violation");
  const pugi::xml_node second = first.next_sibling("testcase");
  EXPECT_STREQ(second.attribute("name").value(), "lines/contested");
  EXPECT_FALSE(second.child("failure"));
  EXPECT_THAT(second.child_value("system-out"), HasSubstr("It is contested."));
  junit.load_string(junit_of(side_by_side(Standing::unexpected)).c_str());
  EXPECT_EQ(junit.child("testsuites").attribute("failures").as_int(), 3);
}

TEST(Ctrf, WhatIsContestedPassesAndSaysSo) {
  const auto tests =
      nlohmann::json::parse(ctrf_of(side_by_side(Standing::tolerated)))["results"]["tests"];
  EXPECT_EQ(tests[1]["status"], "passed");
  EXPECT_EQ(tests[1]["rawStatus"], "contested");
  EXPECT_EQ(tests[1]["extra"]["standing"], "tolerated");
  EXPECT_EQ(tests[0]["status"], "failed");
}

TEST(Csv, TellsOfEachRowWhetherItIsContested) {
  const std::string csv = csv_of(side_by_side(Standing::tolerated));
  EXPECT_THAT(csv, HasSubstr("lines/contested,osmesa:softpipe,contested,tolerated,"));
  EXPECT_THAT(csv, HasSubstr(",contested,1,"));
  EXPECT_THAT(csv, HasSubstr(",illegal,1,"));
}

TEST(Annotations, WhatIsContestedIsAWarningAfterTheErrors) {
  const std::string text = annotations_of(side_by_side(Standing::tolerated));
  EXPECT_THAT(text, StartsWith("::error file=cases/lines/violation.json,"));
  const std::size_t warning = text.find("::warning file=cases/lines/contested.json,");
  ASSERT_NE(warning, std::string::npos);
  EXPECT_LT(text.find("::error file=cases/lines/permitted.json,"), warning);
  EXPECT_THAT(annotations_of(side_by_side(Standing::unexpected)), Not(HasSubstr("::warning")));
}

TEST(Annotations, AFileMayFailAndBeContested) {
  Results results = side_by_side(Standing::tolerated);
  edit_each(results.cases, [](CaseResults& one) { one.file = "cases/all.json"; });
  const std::string text = annotations_of(results);
  EXPECT_EQ(lines_in(text), 2u);
  EXPECT_THAT(text, StartsWith("::error file=cases/all.json,line=1,title=lines/violation"));
  EXPECT_THAT(text, HasSubstr("One more test of this file fails."));
  EXPECT_THAT(text, HasSubstr("\n::warning file=cases/all.json,line=1,title=lines/contested"));
}

TEST(Markdown, TellsWhatIsContestedAfterWhatIsUnexpected) {
  const std::string text = markdown_of(side_by_side(Standing::tolerated));
  EXPECT_THAT(text, HasSubstr("| renderer | violation | contested | permitted |"));
  EXPECT_THAT(text, HasSubstr("| `osmesa:softpipe` | 1 | 1 | 1 | 0 | 0 | 0 | **2** |"));
  EXPECT_THAT(text, HasSubstr("## Unexpected: 2\n"));
  EXPECT_LT(text.find("## Unexpected"), text.find("## Contested: 1\n"));
  EXPECT_THAT(text, HasSubstr("| contested | "));
  EXPECT_THAT(markdown_of(side_by_side(Standing::unexpected)), HasSubstr("## Unexpected: 3\n"));
}

TEST(Outcomes, DetailsNameTheCaseAndTheCommand) {
  visit_outcomes(single(), [](const TestOutcome& outcome) {
    EXPECT_THAT(outcome.details,
                StartsWith("A line in each of so many directions, of one length\npixel (0, 0)"));
    EXPECT_THAT(outcome.details, HasSubstr("explained by: edgecase explain cases/lines/tip.json "
                                           "--against osmesa:softpipe --pixel 0,0\n"));
  });
}

// 20,000 cases that all fail, each with more than is listed.
TEST(Outcomes, LargeRunsStaySmall) {
  const Results results = sample::large_run(20'000, 25);
  const std::string junit = junit_of(results);
  EXPECT_LT(junit.size(), 30'000'000u);
  EXPECT_GT(junit.size(), 15'000'000u) << "the room that there is, is used";
  EXPECT_LT(ctrf_of(results).size(), 30'000'000u);
  EXPECT_LT(markdown_of(results).size(), 100'000u);
  EXPECT_LT(annotations_of(results).size(), 30'000u);
  // Of every file something is said.
  visit_outcomes(results, [](const TestOutcome& outcome) {
    EXPECT_THAT(outcome.details, HasSubstr("pixel (0, 0)"));
    EXPECT_THAT(outcome.details, HasSubstr("more, see results"));
  });
}

// Then there is room for what failed, and little for why.
TEST(Outcomes, LargeRunsOfFourRenderersStaySmall) {
  Results results = sample::large_run(20'000, 1);
  results.renderers.assign(4, results.renderers[0]);
  edit_each(results.cases,
            [](CaseResults& one) { one.results = std::vector<Result>(4, one.results[0]); });
  EXPECT_LT(junit_of(results).size(), 30'000'000u);
  EXPECT_LT(markdown_of(results).size(), 100'000u);
}

TEST(Outcomes, PassingRunsTakeLittle) {
  Results results = sample::large_run(20'000, 0);
  for (std::size_t i = 0; i < results.cases.size(); ++i) {
    results.cases.answer(i, 0).verdict = Verdict::agree;
    results.cases.answer(i, 0).standing = Standing::expected;
  }
  EXPECT_LT(junit_of(results).size(), 5'000'000u);
  EXPECT_LT(ctrf_of(results).size(), 9'000'000u);
  EXPECT_LT(markdown_of(results).size(), 1'000u);
  EXPECT_EQ(annotations_of(results), "");
  EXPECT_EQ(lines_in(csv_of(results)), 1u);
}

TEST(Ctrf, CountsAreThoseOfTheTests) {
  const Results results = sample::results();
  const auto ctrf = nlohmann::json::parse(ctrf_of(results));
  std::map<std::string, int> counts;
  for (const auto& test : ctrf["results"]["tests"]) ++counts[test["status"]];
  const auto& summary = ctrf["results"]["summary"];
  EXPECT_EQ(summary["tests"], ctrf["results"]["tests"].size());
  for (const char* status : {"passed", "failed", "pending", "skipped", "other"})
    EXPECT_EQ(summary[status], counts[status]) << status;
  EXPECT_GT(counts["passed"], 0);
  EXPECT_GT(counts["failed"], 0);
  EXPECT_GT(counts["skipped"], 0);
  EXPECT_EQ(ctrf["results"]["tool"]["name"].get<std::string>().empty(), false);
  pugi::xml_document junit;
  junit.load_string(junit_of(results).c_str());
  EXPECT_EQ(summary["tests"], junit.child("testsuites").attribute("tests").as_int());
}

TEST(Ctrf, SameResultsSameBytes) {
  EXPECT_EQ(ctrf_of(sample::results()), ctrf_of(sample::results()));
}

TEST(Csv, HasARowForEachDisagreement) {
  const Results results = sample::large_run(3, 7);
  const std::string csv = csv_of(results);
  EXPECT_EQ(lines_in(csv), 1u + 21u);
  EXPECT_THAT(csv,
              StartsWith("case,renderer,verdict,standing,x,y,sample,primitive,kind,rule,legality,"
                         "ruling,cause,situation,exact,rendered,explanation,file\r\n"));
}

TEST(Csv, NumbersKeepTheirDigits) {
  Results results = single();
  results.cases.change(0, [](CaseResults& one) {
    Disagreement& d = one.results[0].disagreements[0];
    d.exact = {0.1, 1};
    d.rendered = {0.30000000000000004, std::numeric_limits<double>::infinity()};
  });
  EXPECT_THAT(csv_of(results), HasSubstr(",0.1 1,0.30000000000000004 inf,It differs.,"));
}

TEST(Annotations, EscapeWhatWouldEndThem) {
  Results results = single();
  edit(results.cases, 0)->id = "a,b:c%d\n::warning::e";
  edit(results.cases, 0)->file = "cases/a,b:c%d.json";
  edit(results.cases, 0)->results[0].disagreements[0].explanation = "100 %\n::error::no";
  const std::string text = annotations_of(results);
  EXPECT_EQ(lines_in(text), 1u);
  EXPECT_THAT(text, StartsWith("::error file=cases/a%2Cb%3Ac%25d.json,line=1,title=a%2Cb%3Ac%25d"));
  EXPECT_THAT(text, HasSubstr("100 %25%0A: :error::no%0A"));
}

TEST(Annotations, TheHeaviestTenAndHowManyMore) {
  Results results = sample::large_run(14, 1);
  for (std::size_t i = 0; i < 14; ++i) {
    CaseResults one = results.cases[i];
    one.file = fmt::format("cases/{:02}.json", i);
    Result& result = one.results[0];
    result.verdict = i == 9 ? Verdict::violation : Verdict::permitted;
    result.disagreements.resize(1 + i, result.disagreements[0]);
    results.cases.replace(i, one);
  }
  const std::string text = annotations_of(results);
  EXPECT_EQ(lines_in(text), 11u);
  EXPECT_THAT(text, StartsWith("::error file=cases/09.json,"));
  EXPECT_LT(text.find("cases/13.json"), text.find("cases/12.json"));
  EXPECT_THAT(text, Not(HasSubstr("file=cases/03.json")));
  EXPECT_THAT(text, HasSubstr("\n::notice title=edgecase::4 more are not shown"));
}

TEST(Annotations, OneForAllCasesOfAFile) {
  const std::string text = annotations_of(sample::large_run(500, 1));
  EXPECT_EQ(lines_in(text), 1u);
  EXPECT_THAT(text, HasSubstr("499 more tests of this file fail."));
}

TEST(Annotations, BrokenFilesAndUnmetDrawingsComeFirstWithTheirLines) {
  Results results = single();
  results.diagnostics = {{"cases/broken.json", 7, "/draws", "is no list", "write one"}};
  edit(results.cases, 0)->expect_failures = {"cases/lines/tip.json:23: /expect/0: wrong"};
  const std::string text = annotations_of(results);
  EXPECT_THAT(text, StartsWith("::error file=cases/broken.json,line=7,"));
  EXPECT_THAT(text, HasSubstr("\n::error file=cases/lines/tip.json,line=23,"));
}

TEST(Markdown, CodeHoldsAnything) {
  EXPECT_EQ(markdown_code("plain"), "`plain`");
  EXPECT_EQ(markdown_code("a`b"), "``a`b``");
  EXPECT_EQ(markdown_code("``"), "``` `` ```");
  EXPECT_EQ(markdown_code(" a "), "`  a  `");
  EXPECT_EQ(markdown_code(""), "-");
  EXPECT_EQ(markdown_code("a|b"), "`a|b`");
  EXPECT_EQ(markdown_cell("a|b"), "`a\\|b`");
  EXPECT_EQ(lines_in(markdown_code("a\n# b")), 0u);
}

TEST(Markdown, TellsWhatIsUnexpectedWorstFirst) {
  Results results = sample::large_run(60, 1);
  results.cases.answer(58, 0).verdict = Verdict::permitted;
  results.cases.answer(0, 0).verdict = Verdict::convention;
  const std::string text = markdown_of(results);
  EXPECT_THAT(text, HasSubstr("| `osmesa:softpipe` | 58 | 0 | 1 | 1 | 0 | 0 | **60** |"));
  EXPECT_THAT(text, HasSubstr("## Unexpected: 60\n"));
  EXPECT_THAT(text, HasSubstr("\nand 10 more\n"));
  EXPECT_THAT(text, Not(HasSubstr("convention, unexpected"))) << "after the first 50";
}

// Names that long are cut, and even as many renderers as no run has do not make the page too long.
TEST(Markdown, IsNeverTooLong) {
  Results results = sample::large_run(2, 1);
  edit(results.cases, 0)->id = std::string(10'000, 'n');
  EXPECT_LT(markdown_of(results).size(), 10'000u);
  results.renderers.assign(40'000, results.renderers[0]);
  const std::string text = markdown_of(results);
  EXPECT_LE(text.size(), kMostOfSummary);
  EXPECT_THAT(text, HasSubstr("The rest does not fit here"));
}

TEST(Text, IsShortenedBetweenCharacters) {
  EXPECT_EQ(shortened("abc", 3), "abc");
  EXPECT_EQ(shortened("abcd", 3), "abc\xE2\x80\xA6 (1 bytes more)");
  EXPECT_EQ(shortened("a\xC3\xA4z", 2), "a\xE2\x80\xA6 (3 bytes more)");
}

}  // namespace
}  // namespace edgecase
