// SPDX-License-Identifier: MIT
//
// What is written reads back equal in every field, and the same results give the same bytes.
#include "results/results_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <tuple>

#include "tests/results/expect_case.h"
#include "tests/results/sample_results.h"
#include "tests/support/edit.h"

namespace edgecase {
namespace {

std::string written(const Results& results) {
  std::ostringstream out;
  write_results(results, out);
  return out.str();
}

Results read(const std::string& text) {
  auto outcome = read_results(text);
  if (const auto* error = std::get_if<std::string>(&outcome)) throw std::runtime_error(*error);
  return std::get<Results>(std::move(outcome));
}

void expect_results(const Results& a, const Results& b) {
  EXPECT_EQ(std::tie(a.tool, a.policy, a.latitude, a.policy_digest, a.interrupted, a.left_out,
                     a.whole_suite, a.shard, a.faults, a.refuted, a.rules),
            std::tie(b.tool, b.policy, b.latitude, b.policy_digest, b.interrupted, b.left_out,
                     b.whole_suite, b.shard, b.faults, b.refuted, b.rules));
  ASSERT_EQ(a.renderers.size(), b.renderers.size());
  for (std::size_t i = 0; i < a.renderers.size(); ++i) {
    const auto &r = a.renderers[i], &s = b.renderers[i];
    EXPECT_EQ(std::tie(r.name, r.vendor, r.version, r.device, r.subpixel_bits, r.traits),
              std::tie(s.name, s.vendor, s.version, s.device, s.subpixel_bits, s.traits));
  }
  ASSERT_EQ(a.cases.size(), b.cases.size());
  for (std::size_t i = 0; i < a.cases.size(); ++i) expect_case(a.cases[i], b.cases[i]);
  ASSERT_EQ(a.diagnostics.size(), b.diagnostics.size());
  for (std::size_t i = 0; i < a.diagnostics.size(); ++i)
    EXPECT_EQ(to_string(a.diagnostics[i]), to_string(b.diagnostics[i]));
}

TEST(ResultsJson, EveryFieldReadsBack) {
  const Results results = full_results();
  expect_results(results, read(written(results)));
}

TEST(ResultsJson, WhatIsOnlyCountedReadsBack) {
  const Results results = gross_results();
  const std::string text = written(results);
  expect_results(results, read(text));
  EXPECT_NE(text.find(R"("pixels":"y0 7 y2 0+8 y2 3 y5 1+2")"), std::string::npos);
  EXPECT_EQ(written(read(text)), text);
}

TEST(ResultsJson, CountedDisagreementsThatNoTargetHasAreRefused) {
  const std::string text = written(gross_results());
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{R"("count":12)", R"("count":11)"},
                                                        {"y5 1+2", "y6 1+2"},
                                                        {"y5 1+2", "y5 7+2"},
                                                        {R"("pixel":[3,1])", R"("pixel":[8,1])"},
                                                        {R"("pixel":[3,1])", R"("pixel":[3,-1])"},
                                                        {R"("pixels":"y4 0")", R"("pixels":"")"}}) {
    std::string wrong = text;
    ASSERT_NE(wrong.find(from), std::string::npos) << from;
    EXPECT_THROW(read(wrong.replace(wrong.find(from), from.size(), to)), std::runtime_error) << to;
  }
}

TEST(ResultsJson, EveryNameReadsBack) {
  Results results = results_with({Verdict::agree, Verdict::convention, Verdict::permitted,
                                  Verdict::violation, Verdict::not_run});
  constexpr auto standings = kValues<Standing>;
  for (std::size_t i = 0; i < standings.size(); ++i)
    results.cases.answer(i, 0).standing = standings[i];
  for (const FaultState state : kValues<FaultState>)
    results.faults.push_back({"fake", "fault", "why", "", 1, 2, state});
  expect_results(results, read(written(results)));
}

TEST(ResultsJson, SameResultsGiveTheSameBytes) {
  const Results results = full_results();
  const std::string text = written(results);
  EXPECT_EQ(written(full_results()), text);
  EXPECT_EQ(written(read(text)), text) << "what was read is written as it was";
}

TEST(ResultsJson, EmptyResultsReadBack) {
  expect_results(Results{}, read(written(Results{})));
}

// A whole run's file and one that was merged are the same: neither knows of shards.
TEST(ResultsJson, WhatIsOnlyOfSomeRunsIsAbsentFromOthers) {
  Results results = full_results();
  for (const char* member : {"\"shard\":{\"index\":3,\"count\":4,\"cases\":123,", "\"left_out\":12",
                             "\"again\":{", "\"faults\":[\"fill\""})
    EXPECT_NE(written(results).find(member), std::string::npos) << member;
  results.shard.reset();
  results.left_out = 0;
  for (std::size_t i = 0; i < results.cases.size(); ++i)
    for (std::size_t r = 0; r < results.renderers.size(); ++r) {
      results.cases.answer(i, r).again.reset();
      results.cases.answer(i, r).faults.clear();
    }
  for (const char* member : {"\"shard\"", "\"left_out\"", "\"again\"", "\"faults\":[\"fill"})
    EXPECT_EQ(written(results).find(member), std::string::npos) << member;
}

TEST(ResultsJson, ARampIsCompactAndAbsentWhereItIsEmpty) {
  Results results = full_results();
  EXPECT_NE(written(results).find(R"("ramp":[[0,0,0.1,-0.0,)"), std::string::npos);
  EXPECT_NE(written(results).find(R"(,[1,0,"-inf","-inf","inf","nan"],)"), std::string::npos);
  edit_each(results.cases, [](CaseResults& one) {
    for (Result& result : one.results) result.ramp.clear();
  });
  EXPECT_EQ(written(results).find("\"ramp\""), std::string::npos);
}

TEST(ResultsJson, FragmentsAndViewportsAreAbsentWhereThereIsNothingToTell) {
  Results results = full_results();
  EXPECT_NE(written(results).find(R"("exact_fragments":[[1,0,4,4294967295,)"), std::string::npos);
  EXPECT_NE(written(results).find(R"("rendered_fragments":[[1,0,5,1,"nan",null]])"),
            std::string::npos);
  EXPECT_NE(written(results).find(R"("viewport":[-3,0,8,16]})"), std::string::npos);
  edit_each(results.cases, [](CaseResults& one) {
    one.viewport.reset();
    for (Result& result : one.results) {
      result.exact_fragments.clear();
      result.rendered_fragments.clear();
    }
  });
  EXPECT_EQ(written(results).find("_fragments"), std::string::npos);
  EXPECT_EQ(written(results).find("viewport"), std::string::npos);
}

TEST(ResultsJson, SamplesAreAbsentWhereNothingIsMultisampled) {
  Results results = full_results();
  EXPECT_NE(written(results).find(R"("samples":{"count":2,"positions":[[0.5,0.5],)"),
            std::string::npos);
  edit_each(results.cases, [](CaseResults& one) {
    one.samples = {};
    for (Result& result : one.results) {
      result.samples = result.exact_samples = {};
      result.exact_pixels = {};
    }
  });
  EXPECT_EQ(written(results).find("samples\""), std::string::npos);
  EXPECT_EQ(written(results).find("exact_pixels"), std::string::npos);
}

TEST(ResultsJson, EachCaseStandsOnALineOfItsOwnAndItsHeadBefore) {
  const std::string text = written(full_results());
  EXPECT_TRUE(text.starts_with("{\"edgecase_results\":2,"));
  EXPECT_NE(text.find("\n{\"head\":0,\"file\":"), std::string::npos);
  EXPECT_NE(text.find("\n{\"case\":\"lines/a\",\"head\":0,"), std::string::npos);
  EXPECT_NE(text.find("\n{\"case\":\"lines/b\",\"head\":0,"), std::string::npos);
  EXPECT_NE(text.find("\n{\"end\":true,\"cases\":2,"), std::string::npos);
  EXPECT_EQ(std::ranges::count(text, '\n'), 5);
}

// No picture, no samples, no figure, and no list that is empty.
TEST(ResultsJson, WhatAgreesIsAShortLine) {
  Results results = full_results();
  CaseResults one = results.cases[0];
  Result agrees;
  agrees.verdict = Verdict::agree;
  agrees.pixels = one.pixels;
  agrees.samples = one.samples;
  agrees.pixel_counts = {{2, 0, 0, 0, 0}, 2};
  one.results = {agrees, agrees};
  one.expect_failures.clear();
  results.cases.replace(0, one);
  const std::string text = written(results);
  EXPECT_NE(text.find(R"({"case":"lines/a","head":0,"fragments":17,"results":{)"
                      R"("osmesa:llvmpipe":{"verdict":"agree"},"exec:./a \"b\"":{"verdict":)"
                      R"("agree"}}})"),
            std::string::npos);
  const Results back = read(text);
  EXPECT_EQ(back.cases[0].results[1].pixel_counts, agrees.pixel_counts);
  EXPECT_TRUE(back.cases[0].pixels->empty());
}

// Bytes that are no UTF-8 are replaced; nothing else of the run is lost.
TEST(ResultsJson, InvalidUtf8IsReplacedAndNeverFatal) {
  Results results = full_results();
  for (const char* broken : {"\xff", "a\xc3", "\xed\xa0\x80", "\xf8\x88\x80\x80\x80"}) {
    edit(results.cases, 0)->title = broken;
    edit(results.cases, 0)->results[0].disagreements[0].explanation = broken;
    results.cases.answer(0, 1).failure->reason = broken;
    results.renderers[1].name = std::string("exec:") + broken;
    results.renderers[1].traits = {{broken, broken}};
    results.diagnostics[0].message = broken;
    const Results back = read(written(results));
    EXPECT_NE(back.cases[0].title.find("\uFFFD"), std::string::npos);
    EXPECT_EQ(back.cases[1].title, results.cases[1].title);
    EXPECT_EQ(written(back), written(read(written(back))));
  }
}

TEST(ResultsJson, TheSummaryCountsVerdicts) {
  const Results results = results_with({Verdict::agree, Verdict::agree, Verdict::violation});
  const auto counts = count_verdicts(results, 0);
  EXPECT_EQ(counts, (std::map<Verdict, std::size_t>{{Verdict::agree, 2}, {Verdict::violation, 1}}));
  EXPECT_NE(written(results).find(R"("summary":{"fake":{"agree":2,"violation":1}})"),
            std::string::npos);
  EXPECT_TRUE(count_verdicts(results, 1).empty());
}

// While a run goes on, its cases come in any order, and more becomes known of its renderers.
TEST(ResultsJson, WhatIsWrittenCaseByCaseReadsBack) {
  const Results results = full_results();
  Results begun = results;
  for (RendererInfo& info : begun.renderers) info = {info.name, "", "", "", 4, {}};
  begun.policy_digest = "of no profile";
  std::string text = header_line(begun);
  text += case_lines(results.cases[1], 0, results.renderers);
  text += header_line(results);
  text += case_lines(results.cases[0], 1, results.renderers);
  const auto outcome = read_results(text, Cut::kept);
  ASSERT_TRUE(std::holds_alternative<Results>(outcome)) << std::get<std::string>(outcome);
  const Results& found = std::get<Results>(outcome);
  EXPECT_TRUE(found.interrupted);
  EXPECT_EQ(found.policy_digest, results.policy_digest);
  EXPECT_EQ(header_line(found), header_line(results));
  ASSERT_EQ(found.cases.size(), 2U);
  expect_case(found.cases[0], results.cases[1]);
  expect_case(found.cases[1], results.cases[0]);
}

TEST(ResultsJson, OtherRenderersInTheMiddleAreRefused) {
  Results results = full_results();
  std::string text = header_line(results) + case_lines(results.cases[0], 0, results.renderers);
  std::swap(results.renderers[0].name, results.renderers[1].name);
  const auto outcome = read_results(text + header_line(results), Cut::kept);
  ASSERT_TRUE(std::holds_alternative<std::string>(outcome));
  EXPECT_NE(std::get<std::string>(outcome).find("renderers are others"), std::string::npos);
}

}  // namespace
}  // namespace edgecase
