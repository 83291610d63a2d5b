// SPDX-License-Identifier: MIT
//
// What can only be said of a whole run: with which snap its lines are read, and which of several
// causes is the likeliest.
#include "diff/judge.h"
#include "rules/all_rules.h"
#include "rules/coverage/window.h"

#include <gtest/gtest.h>

#include <deque>

#include "diff/compare.h"
#include "raster/rasterizer.h"
#include "tests/diff/judged_results.h"
#include "tests/diff/named_scenes.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

// All catalogued snaps but these.
std::vector<std::string> all_but(const std::vector<std::string>& snaps) {
  std::vector<std::string> result;
  for (Snap snap : all_snaps())
    if (std::find(snaps.begin(), snaps.end(), name_of(snap)) == snaps.end())
      result.push_back(name_of(snap));
  return result;
}

// A case with one line that is legal under `snaps`, and differs.
Result line_result(std::vector<std::string> snaps, const std::vector<std::string>& causes) {
  Result result;
  Disagreement d;
  d.primitive = 0;
  d.rule = rule_named("line.diamond-exit");
  d.ruling = 1;
  result.disagreements = {d};
  result.illegal_line_snaps = all_but(snaps);
  result.evidence = {{0, causes_named(causes), all_but(snaps), ""}};
  return result;
}

TEST(Judge, ReadsLinesWithTheSnapThatMakesMostCasesLegal) {
  std::deque<Result> results = {line_result({"none", "8-truncate"}, {}),
                                line_result({"8-truncate"}, {}), line_result({"none"}, {}),
                                line_result({"8-truncate"}, {})};
  EXPECT_EQ(judge_all(results), "8-truncate");
  EXPECT_TRUE(is_legal(results[0].disagreements[0]));
  EXPECT_TRUE(is_legal(results[1].disagreements[0]));
  EXPECT_FALSE(is_legal(results[2].disagreements[0]));
  EXPECT_EQ(results[2].verdict, Verdict::violation);
  EXPECT_EQ(results[3].verdict, Verdict::permitted);
}

TEST(Judge, ReadsLinesAsGivenWhereThatIsAsGood) {
  std::deque<Result> results = {line_result({"none", "8-truncate"}, {}),
                                line_result({"8-truncate"}, {}), line_result({"none"}, {})};
  EXPECT_EQ(judge_all(results), "none");
  std::deque<Result> nothing;
  EXPECT_EQ(judge_all(nothing), "none");
}

TEST(Judge, CasesThatDidNotRunHaveNoVote) {
  std::deque<Result> results = {line_result({"8-truncate"}, {}),
                                not_run({FailureKind::crashed, "gone"})};
  results[1].illegal_line_snaps = all_but({"none"});
  EXPECT_EQ(judge_all(results), "8-truncate");
}

TEST(Judge, OnlyOpenChoicesAreConvention) {
  std::deque<Result> results = {
      triangle_result({"triangle.fill-rule=open"}),
      triangle_result({"triangle.fill-rule=left-bottom + triangle.snap=8-half-up"}),
      triangle_result({"triangle.fill-rule=closed"}), triangle_result({})};
  judge_all(results);
  EXPECT_EQ(results[0].verdict, Verdict::permitted);
  EXPECT_EQ(results[1].verdict, Verdict::convention);
  EXPECT_EQ(results[2].verdict, Verdict::permitted);
  EXPECT_EQ(results[3].verdict, Verdict::permitted);
}

TEST(Judge, TheWorstDisagreementDecides) {
  Result result = triangle_result({"triangle.fill-rule=left-bottom"});
  Disagreement illegal;
  illegal.kind = DisagreementKind::value;
  illegal.rule = RuleId::framebuffer_unorm8;
  result.disagreements.push_back(illegal);
  std::deque<Result> results = {result};
  judge_all(results);
  EXPECT_EQ(results[0].verdict, Verdict::violation);
}

// A sample that the letter of a ruling forbids.
Disagreement forbidden_by(int ruling) {
  Disagreement d;
  d.rule = rule_named("clip.volume");
  d.ruling = ruling;
  return d;
}

// The number of the first ruling of that basis.
int ruling_of(Basis basis) {
  for (const Rule& rule : all_rules())
    for (const Ruling& ruling : rule.rulings)
      if (ruling.source.basis == basis) return ruling.number;
  return 0;
}

const int kNormative = ruling_of(Basis::normative);
const int kContested = ruling_of(Basis::contested);

TEST(Judge, WhatAContestedRulingForbidsIsContestedAndNoViolation) {
  ASSERT_GT(kNormative, 0);
  ASSERT_GT(kContested, 0);
  Result contested, violation, both;
  contested.disagreements = {forbidden_by(kContested)};
  violation.disagreements = {forbidden_by(kNormative)};
  both.disagreements = {forbidden_by(kNormative), forbidden_by(kContested)};
  for (Result* result : {&contested, &violation, &both}) result->pixel_counts[Verdict::agree] = 4;
  both.disagreements[1].x = 1;
  std::deque<Result> results = {contested, violation, both};
  judge_all(results);
  EXPECT_EQ(results[0].verdict, Verdict::contested);
  EXPECT_EQ(results[0].disagreements[0].legality, Legality::contested);
  EXPECT_EQ(results[0].pixel_counts[Verdict::contested], 1U);
  EXPECT_EQ(results[0].pixel_counts[Verdict::violation], 0U);
  EXPECT_EQ(results[0].pixel_counts[Verdict::agree], 3U);
  EXPECT_EQ(results[1].verdict, Verdict::violation);
  EXPECT_EQ(results[1].disagreements[0].legality, Legality::illegal);
  EXPECT_EQ(results[2].verdict, Verdict::violation) << "the worst decides";
  EXPECT_EQ(results[2].pixel_counts[Verdict::contested], 1U);
  EXPECT_EQ(results[2].pixel_counts[Verdict::violation], 1U);
}

TEST(Judge, TheRulingOfTodayDecidesWhatIsContested) {
  Result result;
  result.disagreements = {forbidden_by(kNormative), forbidden_by(kContested)};
  result.disagreements[0].legality = Legality::contested;  // as an earlier version judged
  std::deque<Result> results = {result};
  for (int round = 0; round < 2; ++round) {
    judge_all(results);
    EXPECT_EQ(results[0].disagreements[0].legality, Legality::illegal);
    EXPECT_EQ(results[0].disagreements[1].legality, Legality::contested);
  }
}

TEST(Judge, WhatIsContestedIsAViolationOfAPolicyWithoutLatitude) {
  Result result;
  result.disagreements = {forbidden_by(kContested)};
  std::deque<Result> results = {result};
  judge_all(results, Latitude::none);
  EXPECT_EQ(results[0].verdict, Verdict::violation);
}

TEST(Judge, PermittedValuesArePermittedAndNeverAgreement) {
  Result result;
  ValueAggregate values;
  values.attribute = "color";
  values.rule = rule_named("attribute.smooth");
  values.differing = {{1, 1, 0}};
  result.values = {values};
  std::deque<Result> results = {result, triangle_result({"triangle.fill-rule=left-bottom"})};
  results[1].values = {values};
  judge_all(results);
  EXPECT_EQ(results[0].verdict, Verdict::permitted);
  EXPECT_EQ(results[1].verdict, Verdict::permitted);
}

TEST(Judge, WithoutLatitudeAnyDifferenceIsAViolation) {
  Result clean;
  std::deque<Result> results = {triangle_result({"triangle.fill-rule=left-bottom"}), clean,
                                not_run({FailureKind::timed_out, "5 s"})};
  judge_all(results, Latitude::none);
  EXPECT_EQ(results[0].verdict, Verdict::violation);
  EXPECT_TRUE(is_legal(results[0].disagreements[0])) << "what OpenGL says of it is still told";
  EXPECT_EQ(results[1].verdict, Verdict::agree);
  EXPECT_EQ(results[2].verdict, Verdict::not_run);
}

TEST(Judge, NotRunStaysNotRun) {
  std::deque<Result> results = {not_run({FailureKind::crashed, "signal 11"})};
  judge_all(results);
  EXPECT_EQ(results[0].verdict, Verdict::not_run);
  EXPECT_EQ(results[0].fingerprint, "crashed");
  ASSERT_TRUE(results[0].failure.has_value());
  EXPECT_EQ(results[0].failure->reason, "signal 11");
}

std::string fingerprint(Result result) {
  Result* const list[] = {&result};
  judge(list, Latitude::opengl);
  return result.fingerprint;
}

TEST(Fingerprint, IsOfRuleKindAndPixelsOnly) {
  const Result base = triangle_result({"triangle.fill-rule=left-bottom"}, 3);
  const std::string print = fingerprint(base);
  EXPECT_EQ(print.size(), 16u);
  for (const auto& change : std::initializer_list<void (*)(Disagreement&)>{
           [](Disagreement& d) { d.rule = rule_named("triangle.shared-edge"); },
           [](Disagreement& d) { d.kind = DisagreementKind::extra; },
           [](Disagreement& d) { d.x = 4; }, [](Disagreement& d) { d.y = 4; }}) {
    Result changed = base;
    change(changed.disagreements[0]);
    EXPECT_NE(fingerprint(changed), print);
  }
  Result other = base;
  Disagreement& d = other.disagreements[0];
  d.explanation = "said otherwise";
  d.figure.marks = {{MarkRole::sample, false, {{1, 2}}, ""}};
  d.exact = {1};
  d.rendered = {0};
  other.evidence[0].causes = causes_named({"triangle.fill-rule=top-left"});
  EXPECT_EQ(fingerprint(other), print);
}

TEST(Fingerprint, OfASetDoesNotDependOnOrderOrNumber) {
  Result result = triangle_result({}, 3);
  result.disagreements.push_back(triangle_result({}, 5).disagreements[0]);
  const std::string print = fingerprint(result);
  std::swap(result.disagreements[0], result.disagreements[1]);
  EXPECT_EQ(fingerprint(result), print);
  EXPECT_EQ(fingerprint(Result{}), "");
}

// A run of many scenes against a renderer that snaps, ties and errs.
std::deque<Result> faulty_run() {
  Policy renderer;
  renderer.rules = {{"triangle.fill-rule", "bottom-left"},
                    {"subpixel.snap", "8-half-up"},
                    {"line.diamond-exit", "right-top"}};
  RandomScenes random(41);
  std::deque<Result> results;
  for (int i = 0; i < 120; ++i) {
    if (i % 20 == 19) {
      results.push_back(not_run({FailureKind::unsupported, "no"}));
      continue;
    }
    const Scene scene =
        random.next({10, i % 2 == 0 ? Fixed::kOne / 2 : Fixed::kOne / 2048, 3, true});
    Rendering rendered = rasterize(scene, renderer);
    if (i % 7 == 0 && !rendered.fragments.empty()) rendered.fragments.pop_back();
    results.push_back(compare(scene, {}, rasterize(scene, {}), rendered, {8}));
  }
  return results;
}

void expect_same(const std::deque<Result>& a, const std::deque<Result>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].verdict, b[i].verdict) << i;
    EXPECT_EQ(a[i].fingerprint, b[i].fingerprint) << i;
    ASSERT_EQ(a[i].disagreements.size(), b[i].disagreements.size());
    for (std::size_t d = 0; d < a[i].disagreements.size(); ++d) {
      EXPECT_EQ(is_legal(a[i].disagreements[d]), is_legal(b[i].disagreements[d])) << i;
      EXPECT_EQ(a[i].disagreements[d].cause, b[i].disagreements[d].cause) << i;
      EXPECT_EQ(a[i].disagreements[d].ruling, b[i].disagreements[d].ruling) << i;
    }
  }
}

TEST(Judge, TwiceChangesNothing) {
  std::deque<Result> once = faulty_run();
  const std::string reading = judge_all(once);
  std::deque<Result> twice = once;
  EXPECT_EQ(judge_all(twice), reading);
  expect_same(once, twice);
}

TEST(Judge, MergedShardsGiveWhatTheWholeGives) {
  std::deque<Result> whole = faulty_run();
  const std::string reading = judge_all(whole);
  for (std::size_t shards : {2u, 3u, 7u}) {
    // Each shard is judged by itself first, then all together.
    std::deque<Result> merged = faulty_run();
    for (std::size_t shard = 0; shard < shards; ++shard) {
      std::vector<Result*> part;
      for (std::size_t i = shard; i < merged.size(); i += shards) part.push_back(&merged[i]);
      judge(part, Latitude::opengl);
    }
    EXPECT_EQ(judge_all(merged), reading);
    expect_same(whole, merged);
  }
}

TEST(Judge, FindsWhatTheRendererOfARunFollows) {
  std::deque<Result> results = faulty_run();
  judge_all(results);
  int convention = 0;
  for (const Result& result : results)
    for (const Disagreement& d : result.disagreements)
      if (d.rule == "triangle.fill-rule" &&
          text_of(d.cause).find("fill-rule") != std::string::npos) {
        EXPECT_NE(text_of(d.cause).find("triangle.fill-rule=bottom-left"), std::string::npos);
        ++convention;
      }
  EXPECT_GT(convention, 10);
}

// What a verdict and a report are made of.
std::string description_of(const Result& result) {
  std::string text = std::string(name_of(result.verdict)) + " " + result.fingerprint;
  for (const Disagreement& d : result.disagreements)
    text += (is_legal(d) ? "; legal " : "; illegal ") + text_of(d.cause) + " " +
            std::to_string(d.ruling);
  return text;
}

// Random scenes as a renderer with another fill rule and another snap draws them.
std::deque<Result> drawn_results() {
  Policy other;
  other.rules["triangle.fill-rule"] = "bottom-right";
  other.rules["line.snap"] = "4-half-even";
  RandomScenes scenes(3);
  std::deque<Result> results;
  for (int i = 0; i < 60; ++i) {
    const Scene scene = scenes.next({});
    results.push_back(compare(scene, Policy{}, rasterize(scene, Policy{}), rasterize(scene, other),
                              {8, nullptr}));
  }
  return results;
}

TEST(Judge, UnderTheReadingOfTheRunIsJudgingTheRun) {
  const std::deque<Result> drawn = drawn_results();
  std::deque<Result> at_once = drawn;
  const std::string snap = judge_all(at_once);
  std::deque<Result> apart = drawn;
  const RunReading reading = read_run(pointers(apart));
  EXPECT_EQ(reading.line_snap, snap);
  EXPECT_FALSE(reading.alternatives.empty());
  int differ_alone = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    // One by one, as a search meets them.
    Result* const one = &apart[i];
    judge({&one, 1}, Latitude::opengl, reading);
    EXPECT_EQ(description_of(apart[i]), description_of(at_once[i])) << i;
    std::deque<Result> alone = {drawn[i]};
    judge_all(alone);
    differ_alone += description_of(alone[0]) != description_of(at_once[i]) ? 1 : 0;
  }
  EXPECT_GT(differ_alone, 0) << "the reading is of no account here";
}

TEST(Judge, AReadingThatDoesNotKnowAnAlternativeSpeaksForNone) {
  const std::string a = "triangle.fill-rule=left-bottom", b = "triangle.fill-rule=bottom-left";
  std::deque<Result> results = {triangle_result({a, b})};
  judge(pointers(results), Latitude::opengl, RunReading{});
  EXPECT_EQ(results[0].disagreements[0].cause, a) << "the first in catalogue order";
  RunReading reading;
  reading.alternatives[cause_named(b).parts[0]] = 1;
  judge(pointers(results), Latitude::opengl, reading);
  EXPECT_EQ(results[0].disagreements[0].cause, b);
}

// Values that differ, a failure, and agreement: the reading is for coverage.
TEST(Judge, WhatDoesNotDependOnTheRunIsTheSameUnderEveryReading) {
  std::deque<Result> results = faulty_run();
  for (const Result& drawn : drawn_results()) results.push_back(drawn);
  Result values;
  values.values.resize(2);
  values.values[0].differing = {{1, 2, 0}, {2, 2, 0}};
  values.values[1].differing = {{1, 2, 0}};
  values.values[1].cause = cause_named("triangle.fill-rule=left-bottom");
  values.pixel_counts[Verdict::agree] = 16;
  results.push_back(values);
  results.emplace_back().failure = Failure{FailureKind::crashed, "signal 11"};
  const RunReading reading = read_run(pointers(results));
  int independent = 0;
  for (const Result& result : results) {
    if (depends_on_run(result)) continue;
    ++independent;
    Result alone = result;
    Result in_run = result;
    for (const auto& [judged, with] :
         {std::pair(&alone, RunReading{}), std::pair(&in_run, reading)}) {
      Result* const one = judged;
      judge({&one, 1}, Latitude::opengl, with);
    }
    EXPECT_EQ(description_of(alone), description_of(in_run));
    EXPECT_EQ(alone.pixel_counts, in_run.pixel_counts);
  }
  EXPECT_GT(independent, 3);
  EXPECT_LT(independent, static_cast<int>(results.size()));
}

}  // namespace
}  // namespace edgecase
