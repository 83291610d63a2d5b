// SPDX-License-Identifier: MIT
//
// What is written reads back equal in every field, and the same results give the same bytes.
#include "results/results_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>

#include "results/packed_text.h"
#include "tests/results/sample_results.h"

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

// Equal to the bit, the sign of zero included; any NaN equals any other.
void expect_number(double a, double b) {
  if (std::isnan(a) && std::isnan(b)) return;
  EXPECT_EQ(a, b);
  EXPECT_EQ(std::signbit(a), std::signbit(b));
}

void expect_numbers(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) expect_number(a[i], b[i]);
}

void expect_figure(const Figure& a, const Figure& b) {
  ASSERT_EQ(a.marks.size(), b.marks.size());
  for (std::size_t i = 0; i < a.marks.size(); ++i) {
    EXPECT_EQ(a.marks[i].role, b.marks[i].role);
    EXPECT_EQ(a.marks[i].closed, b.marks[i].closed);
    EXPECT_EQ(a.marks[i].points, b.marks[i].points);
    EXPECT_EQ(a.marks[i].label, b.marks[i].label);
  }
}

void expect_disagreement(const Disagreement& a, const Disagreement& b) {
  EXPECT_EQ(std::tie(a.x, a.y, a.sample, a.primitive, a.kind, a.rule, a.legality, a.cause,
                     a.situation, a.ruling, a.explanation),
            std::tie(b.x, b.y, b.sample, b.primitive, b.kind, b.rule, b.legality, b.cause,
                     b.situation, b.ruling, b.explanation));
  ASSERT_EQ(a.upright.has_value(), b.upright.has_value());
  if (a.upright) {
    EXPECT_EQ(std::tie(a.upright->rule, a.upright->ruling, a.upright->legality, a.upright->cause),
              std::tie(b.upright->rule, b.upright->ruling, b.upright->legality, b.upright->cause));
  }
  expect_numbers(a.exact, b.exact);
  expect_numbers(a.rendered, b.rendered);
  expect_figure(a.figure, b.figure);
}

void expect_values(const ValueAggregate& a, const ValueAggregate& b) {
  EXPECT_EQ(std::tie(a.attribute, a.rule, a.ruling, a.cause, a.compared, a.components,
                     a.worst_component, a.ulp_histogram),
            std::tie(b.attribute, b.rule, b.ruling, b.cause, b.compared, b.components,
                     b.worst_component, b.ulp_histogram));
  const auto place = [](const ValueAggregate::Place& p) {
    return std::tuple(p.x, p.y, p.primitive);
  };
  EXPECT_EQ(place(a.worst), place(b.worst));
  EXPECT_EQ(packed_places(a.differing), packed_places(b.differing));
  expect_number(a.worst_exact, b.worst_exact);
  expect_number(a.worst_rendered, b.worst_rendered);
  expect_number(a.worst_ulp, b.worst_ulp);
  expect_number(a.mean_ulp, b.mean_ulp);
  expect_number(a.worst_relative, b.worst_relative);
}

void expect_ramp(const std::vector<Result::LevelPoint>& a,
                 const std::vector<Result::LevelPoint>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(std::tie(a[i].x, a[i].y), std::tie(b[i].x, b[i].y));
    expect_numbers({a[i].exact, a[i].low, a[i].high, a[i].rendered},
                   {b[i].exact, b[i].low, b[i].high, b[i].rendered});
  }
}

void expect_fragments(const std::vector<Result::ReportedFragment>& a,
                      const std::vector<Result::ReportedFragment>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Fragment &f = a[i].fragment, &g = b[i].fragment;
    EXPECT_EQ(
        std::tie(f.x, f.y, f.primitive, f.coverage, f.has_depth, f.has_color, f.detail, a[i].pass),
        std::tie(g.x, g.y, g.primitive, g.coverage, g.has_depth, g.has_color, g.detail, b[i].pass));
    if (f.has_depth) expect_number(f.depth, g.depth);
    for (std::size_t c = 0; f.has_color && c < f.color.size(); ++c)
      expect_number(f.color[c], g.color[c]);
  }
}

void expect_result(const KnownResult& a, const KnownResult& b) {
  EXPECT_EQ(a.refuted, b.refuted);
  EXPECT_EQ(a.pixel_counts, b.pixel_counts);
  EXPECT_TRUE(a.samples == b.samples);
  EXPECT_TRUE(a.exact_samples == b.exact_samples);
  EXPECT_EQ(a.exact_pixels, b.exact_pixels);
  expect_ramp(a.ramp, b.ramp);
  expect_fragments(a.exact_fragments, b.exact_fragments);
  expect_fragments(a.rendered_fragments, b.rendered_fragments);
  EXPECT_EQ(a.faults, b.faults);
  EXPECT_EQ(a.again, b.again);
  EXPECT_EQ(std::tie(a.verdict, a.fingerprint, a.illegal_line_snaps, a.pixels, a.standing,
                     a.standing_reason),
            std::tie(b.verdict, b.fingerprint, b.illegal_line_snaps, b.pixels, b.standing,
                     b.standing_reason));
  ASSERT_EQ(a.failure.has_value(), b.failure.has_value());
  if (a.failure) {
    EXPECT_EQ(a.failure->kind, b.failure->kind);
    EXPECT_EQ(a.failure->reason, b.failure->reason);
  }
  ASSERT_EQ(a.disagreements.size(), b.disagreements.size());
  for (std::size_t i = 0; i < a.disagreements.size(); ++i)
    expect_disagreement(a.disagreements[i], b.disagreements[i]);
  ASSERT_EQ(a.values.size(), b.values.size());
  for (std::size_t i = 0; i < a.values.size(); ++i) expect_values(a.values[i], b.values[i]);
  ASSERT_EQ(a.evidence.size(), b.evidence.size());
  for (std::size_t i = 0; i < a.evidence.size(); ++i) {
    const auto &e = a.evidence[i], &f = b.evidence[i];
    EXPECT_EQ(std::tie(e.primitive, e.pass, e.causes, e.illegal_line_snaps, e.broken_clause),
              std::tie(f.primitive, f.pass, f.causes, f.illegal_line_snaps, f.broken_clause));
  }
}

void expect_case(const CaseResults& a, const CaseResults& b) {
  EXPECT_EQ(std::tie(a.id, a.title, a.why, a.rules, a.spec, a.origin, a.tags, a.file, a.surface,
                     a.file_digest),
            std::tie(b.id, b.title, b.why, b.rules, b.spec, b.origin, b.tags, b.file, b.surface,
                     b.file_digest));
  EXPECT_EQ(std::tie(a.width, a.height, a.pixels, a.fragments, a.expect_failures),
            std::tie(b.width, b.height, b.pixels, b.fragments, b.expect_failures));
  ASSERT_EQ(a.viewport.has_value(), b.viewport.has_value());
  if (a.viewport) {
    EXPECT_EQ(std::tie(a.viewport->x, a.viewport->y, a.viewport->width, a.viewport->height),
              std::tie(b.viewport->x, b.viewport->y, b.viewport->width, b.viewport->height));
  }
  EXPECT_TRUE(a.samples == b.samples);
  expect_figure(a.figure, b.figure);
  ASSERT_EQ(a.results.size(), b.results.size());
  for (std::size_t i = 0; i < a.results.size(); ++i) expect_result(a.results[i], b.results[i]);
}

void expect_results(const Results& a, const Results& b) {
  EXPECT_EQ(std::tie(a.tool, a.policy, a.latitude, a.policy_digest, a.interrupted, a.left_out,
                     a.whole_suite, a.shard, a.faults),
            std::tie(b.tool, b.policy, b.latitude, b.policy_digest, b.interrupted, b.left_out,
                     b.whole_suite, b.shard, b.faults));
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

TEST(ResultsJson, EveryNameReadsBack) {
  Results results = results_with({Verdict::agree, Verdict::convention, Verdict::permitted,
                                  Verdict::violation, Verdict::not_run});
  constexpr auto standings = kValues<Standing>;
  for (std::size_t i = 0; i < standings.size(); ++i)
    results.cases.at(i).results[0].standing = standings[i];
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
  for (CaseResults& one : results.cases)
    for (KnownResult& result : one.results) {
      result.again.reset();
      result.faults.clear();
    }
  for (const char* member : {"\"shard\"", "\"left_out\"", "\"again\"", "\"faults\":[\"fill"})
    EXPECT_EQ(written(results).find(member), std::string::npos) << member;
}

TEST(ResultsJson, ARampIsCompactAndAbsentWhereItIsEmpty) {
  Results results = full_results();
  EXPECT_NE(written(results).find(R"("ramp":[[0,0,0.1,-0.0,)"), std::string::npos);
  EXPECT_NE(written(results).find(R"(,[1,0,"-inf","-inf","inf","nan"],)"), std::string::npos);
  for (CaseResults& one : results.cases)
    for (Result& result : one.results) result.ramp.clear();
  EXPECT_EQ(written(results).find("\"ramp\""), std::string::npos);
}

TEST(ResultsJson, FragmentsAndViewportsAreAbsentWhereThereIsNothingToTell) {
  Results results = full_results();
  EXPECT_NE(written(results).find(R"("exact_fragments":[[1,0,4,4294967295,)"), std::string::npos);
  EXPECT_NE(written(results).find(R"("rendered_fragments":[[1,0,5,1,"nan",null]])"),
            std::string::npos);
  EXPECT_NE(written(results).find(R"("viewport":[-3,0,8,16]})"), std::string::npos);
  for (CaseResults& one : results.cases) {
    one.viewport.reset();
    for (Result& result : one.results) {
      result.exact_fragments.clear();
      result.rendered_fragments.clear();
    }
  }
  EXPECT_EQ(written(results).find("_fragments"), std::string::npos);
  EXPECT_EQ(written(results).find("viewport"), std::string::npos);
}

TEST(ResultsJson, SamplesAreAbsentWhereNothingIsMultisampled) {
  Results results = full_results();
  EXPECT_NE(written(results).find(R"("samples":{"count":2,"positions":[[0.5,0.5],)"),
            std::string::npos);
  for (CaseResults& one : results.cases) {
    one.samples = {};
    for (Result& result : one.results) {
      result.samples = result.exact_samples = {};
      result.exact_pixels = {};
    }
  }
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
  CaseResults& one = results.cases[0];
  Result agrees;
  agrees.verdict = Verdict::agree;
  agrees.pixels = one.pixels;
  agrees.samples = one.samples;
  agrees.pixel_counts = {2, 0, 0, 0, 0, 2};
  one.results = {agrees, agrees};
  one.expect_failures.clear();
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
    results.cases[0].title = broken;
    results.cases[0].results[0].disagreements[0].explanation = broken;
    results.cases[0].results[1].failure->reason = broken;
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

}  // namespace
}  // namespace edgecase
