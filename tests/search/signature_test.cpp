// SPDX-License-Identifier: MIT
#include "search/trial.h"

#include <gtest/gtest.h>

#include "results/clusters.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

Disagreement extra(const std::string& cause, bool legal, const std::string& situation = "first") {
  Disagreement d;
  d.kind = DisagreementKind::extra;
  d.rule = rule_named("line.diamond-exit");
  d.cause = cause_named(cause);
  d.legality = by_letter(legal);
  d.situation = situation;
  return d;
}

TEST(Signature, OfWhatHasACauseThatIsAllowedIsTheCause) {
  Result result;
  result.disagreements = {extra("line.algorithm=bresenham", true)};
  const auto signatures = signatures_of(result, Surface::window);
  ASSERT_EQ(signatures.size(), 1u);
  EXPECT_EQ(signatures[0].cause, "line.algorithm=bresenham");
  EXPECT_EQ(signatures[0].rule, "");
  EXPECT_EQ(signatures[0].kind, "");
  EXPECT_EQ(signatures[0].situation, "");
  EXPECT_EQ(title_of(signatures[0]), "line.algorithm=bresenham, allowed, window");
  EXPECT_EQ(signature_of(result.disagreements[0], Surface::window), signatures[0]);
}

TEST(Signature, OfACauseThatBreaksRulesIsEachOfThemBesideIt) {
  Result result;
  Disagreement missing = extra("line.algorithm=bresenham", false);
  missing.kind = DisagreementKind::missing;
  result.disagreements = {extra("line.algorithm=bresenham", false), missing, missing};
  const auto signatures = signatures_of(result, Surface::fbo);
  ASSERT_EQ(signatures.size(), 2u);
  EXPECT_EQ(title_of(signatures[0]),
            "line.diamond-exit extra by line.algorithm=bresenham, not allowed, fbo");
  EXPECT_EQ(title_of(signatures[1]),
            "line.diamond-exit missing by line.algorithm=bresenham, not allowed, fbo");
  EXPECT_EQ(signatures[0].situation, "");
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(signature_of(result.disagreements[i], Surface::fbo), signatures[i == 0 ? 0 : 1]);
  EXPECT_EQ(disagreements_of(result, signatures[0]).size(), 1u);
  EXPECT_EQ(disagreements_of(result, signatures[1]).size(), 2u);
}

TEST(Signature, OfWhatHasNoneIsRuleKindAndSituation) {
  Result result;
  result.disagreements = {extra("", true)};
  const auto signatures = signatures_of(result, Surface::fbo);
  ASSERT_EQ(signatures.size(), 1u);
  EXPECT_EQ(signatures[0].rule, "line.diamond-exit");
  EXPECT_EQ(signatures[0].kind, "extra");
  EXPECT_EQ(title_of(signatures[0]), "line.diamond-exit extra, first, allowed, fbo");
}

TEST(Signature, EachOfThemOnceAndWhatIsNotAllowedFirst) {
  Result result;
  result.disagreements = {
      extra("line.snap=none", true), extra("", true),         extra("", true), extra("", false),
      extra("", false, "last"),      extra("", false, "last")};
  const auto signatures = signatures_of(result, Surface::fbo);
  ASSERT_EQ(signatures.size(), 4u);
  EXPECT_EQ(signatures[0].situation, "last") << "two of them";
  EXPECT_EQ(signatures[1].situation, "first");
  EXPECT_EQ(signatures[1].legality, Legality::illegal);
  EXPECT_EQ(signatures[2].legality, Legality::legal);
  EXPECT_EQ(signatures[3].cause, "line.snap=none");
}

TEST(Signature, DiffersWithSurfaceAndLegality) {
  Result legal;
  legal.disagreements = {extra("", true)};
  Result illegal;
  illegal.disagreements = {extra("", false)};
  const auto one = signatures_of(legal, Surface::fbo).at(0);
  EXPECT_NE(one, signatures_of(illegal, Surface::fbo).at(0));
  EXPECT_NE(one, signatures_of(legal, Surface::window).at(0));
  EXPECT_EQ(one, signatures_of(legal, Surface::fbo).at(0));
}

TEST(Signature, OfValuesNamesTheAttribute) {
  Result result;
  ValueAggregate values;
  values.attribute = "depth";
  values.rule = rule_named("attribute.smooth");
  result.values = {values};
  EXPECT_TRUE(signatures_of(result, Surface::fbo).empty()) << "none of them differs";
  result.values[0].differing = {{1, 2, 0}};
  const auto signatures = signatures_of(result, Surface::fbo);
  ASSERT_EQ(signatures.size(), 1u);
  EXPECT_EQ(signatures[0].attribute, "depth");
  EXPECT_EQ(title_of(signatures[0]), "attribute.smooth depth within what is permitted, fbo");
}

TEST(Signature, FailuresOfTheRendererAreFindsAndRefusalsAreNot) {
  const auto of_failure = [](FailureKind kind) {
    Result result;
    result.failure = Failure{kind, "why"};
    return signatures_of(result, Surface::fbo);
  };
  ASSERT_EQ(of_failure(FailureKind::crashed).size(), 1u);
  EXPECT_EQ(title_of(of_failure(FailureKind::crashed)[0]), "the renderer fails: crashed, fbo");
  EXPECT_EQ(of_failure(FailureKind::timed_out).size(), 1u);
  EXPECT_EQ(of_failure(FailureKind::garbage).size(), 1u);
  EXPECT_NE(of_failure(FailureKind::garbage), of_failure(FailureKind::crashed));
  EXPECT_TRUE(of_failure(FailureKind::unsupported).empty());
  EXPECT_TRUE(of_failure(FailureKind::unavailable).empty());
}

TEST(Signature, NamesTheDisagreementsThatHaveIt) {
  Result result;
  result.disagreements = {extra("", false, "first"), extra("", false, "last"),
                          extra("", false, "first")};
  result.disagreements[2].x = 7;
  const auto signatures = signatures_of(result, Surface::window);
  const auto found = disagreements_of(result, signatures.at(0));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0], &result.disagreements[0]);
  EXPECT_EQ(found[1]->x, 7);
}

TEST(Signature, IsThatOfTheClusterInTheResults) {
  CaseResults one;
  one.id = "one";
  one.surface = "window";
  one.results.resize(2);
  one.results[1].disagreements = {extra("", false)};
  EXPECT_TRUE(signatures_of(one, 0).empty());
  const auto signatures = signatures_of(one, 1);
  Results results;
  results.renderers.resize(2);
  results.cases.push_back(one);
  const auto clusters = clusters_of(results, 1);
  ASSERT_EQ(signatures.size(), clusters.size());
  EXPECT_EQ(signatures[0].situation, clusters[0].situations.front().text);
  EXPECT_EQ(signatures[0].surface, "window");
}

}  // namespace
}  // namespace edgecase
