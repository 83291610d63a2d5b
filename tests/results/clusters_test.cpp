// SPDX-License-Identifier: MIT
#include "results/clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "results/results_json.h"
#include "rules/all_rules.h"
#include "tests/results/sample_results.h"
#include "tests/support/causes.h"
#include "tests/support/edit.h"

namespace edgecase {
namespace {

constexpr const char* kLines = "line.diamond-exit";
constexpr const char* kFill = "triangle.fill-rule";

Disagreement disagreement(const char* rule, DisagreementKind kind, bool legal,
                          const std::string& cause, const std::string& situation) {
  Disagreement d;
  d.rule = rule_named(rule);
  d.kind = kind;
  d.legality = by_letter(legal);
  d.cause = cause_named(cause);
  d.situation = situation;
  return d;
}

Disagreement unexplained(bool legal, const std::string& situation,
                         DisagreementKind kind = DisagreementKind::missing) {
  return disagreement(kLines, kind, legal, "", situation);
}

// A case of so many primitives and so large a target, with these disagreements in columns 0, 1, ...
CaseResults case_of(const std::string& id, std::size_t primitives, int size,
                    std::vector<Disagreement> disagreements) {
  CaseResults one;
  one.id = id;
  one.surface = "fbo";
  one.width = size;
  one.height = size;
  one.figure.marks.resize(primitives);
  one.figure.marks.push_back({MarkRole::vertex, false, {}, ""});
  for (std::size_t i = 0; i < disagreements.size(); ++i) {
    disagreements[i].x = static_cast<int>(i);
    disagreements[i].y = size - 1;
    disagreements[i].primitive = 3;
  }
  one.results.resize(1);
  one.results[0].disagreements = std::move(disagreements);
  return one;
}

Results results_of(const std::vector<CaseResults>& cases) {
  Results results;
  results.renderers.resize(1);
  results.renderers[0].name = "fake";
  results.cases = list_of(cases);
  return results;
}

std::vector<std::string> titles(const std::vector<Cluster>& clusters) {
  std::vector<std::string> result;
  for (const Cluster& cluster : clusters) result.push_back(title_of(cluster));
  return result;
}

using Titles = std::vector<std::string>;

TEST(Clusters, WithoutDisagreementsThereAreNone) {
  EXPECT_TRUE(clusters_of(Results{}, 0).empty());
  EXPECT_TRUE(clusters_of(results_of({case_of("a", 1, 4, {})}), 0).empty());
  EXPECT_TRUE(clusters_of(results_of({case_of("a", 1, 4, {unexplained(true, "s")})}), 1).empty());
}

TEST(Clusters, UnexplainedOnesAreTakenTogetherByRuleAndKindAndTellTheirSituations) {
  const auto clusters = clusters_of(
      results_of({case_of("a", 1, 4, {unexplained(true, "first"), unexplained(true, "first")}),
                  case_of("b", 1, 4,
                          {unexplained(true, "first"), unexplained(true, "last"),
                           unexplained(true, "first", DisagreementKind::extra),
                           disagreement(kFill, DisagreementKind::missing, true, "", "first")})}),
      0);
  EXPECT_EQ(titles(clusters),
            (Titles{"line.diamond-exit missing, fbo", "line.diamond-exit extra, fbo",
                    "triangle.fill-rule missing, fbo"}));
  EXPECT_EQ(clusters[0].disagreements, 4U);
  EXPECT_EQ(clusters[0].cases, 2U);
  EXPECT_EQ(clusters[0].situations,
            (std::vector<ClusterSituation>{{"first", false, 3, 2}, {"last", false, 1, 1}}));
  EXPECT_EQ(clusters[1].disagreements, 1U);
}

TEST(Clusters, ExplainedOnesAreTakenTogetherByCauseAlone) {
  const std::string cause = "triangle.snap=8-half-up";
  const auto clusters = clusters_of(
      results_of({case_of("a", 1, 4,
                          {disagreement(kFill, DisagreementKind::missing, true, cause, "here"),
                           disagreement(kFill, DisagreementKind::extra, true, cause, "there"),
                           disagreement("triangle.shared-edge", DisagreementKind::missing, false,
                                        cause, "here")})}),
      0);
  ASSERT_EQ(clusters.size(), 2U) << "legal and illegal are not mixed";
  EXPECT_EQ(clusters[0].rule, "triangle.shared-edge");
  EXPECT_EQ(clusters[0].kind, "missing");
  EXPECT_EQ(clusters[0].legality, Legality::illegal);
  EXPECT_EQ(clusters[1].rule, kFill);
  EXPECT_EQ(clusters[1].kind, "") << "several kinds";
  EXPECT_TRUE(clusters[1].situations.empty());
  EXPECT_EQ(clusters[1].cause, cause);
  EXPECT_EQ(clusters[1].legality, Legality::legal);
}

constexpr const char* kClosed = "triangle.fill-rule=closed";
constexpr const char* kOpen = "triangle.fill-rule=open";

Disagreement extra(const std::string& cause) {
  return disagreement(kFill, DisagreementKind::extra, false, cause, "triangle, here");
}

// So many cases for each cause.
Results results_by(const std::vector<std::pair<std::string, int>>& causes) {
  std::vector<CaseResults> cases;
  for (const auto& [cause, count] : causes)
    for (int i = 0; i < count; ++i)
      cases.push_back(case_of("case" + std::to_string(100 + cases.size()), 1, 4, {extra(cause)}));
  return results_of(cases);
}

TEST(Clusters, OfARuleAndKindHaveTheCauseOfNineInTen) {
  const auto of_most = clusters_of(results_by({{kClosed, 9}, {kOpen, 1}}), 0);
  EXPECT_EQ(titles(of_most), Titles{"triangle.fill-rule=closed, fbo"});
  EXPECT_EQ(of_most[0].cases, 10U);
  EXPECT_TRUE(of_most[0].situations.empty());
  const auto of_fewer = clusters_of(results_by({{kClosed, 8}, {kOpen, 1}}), 0);
  EXPECT_EQ(titles(of_fewer), Titles{"triangle.fill-rule extra, fbo"});
  EXPECT_EQ(of_fewer[0].situations,
            (std::vector<ClusterSituation>{{"as if triangle.fill-rule=closed", false, 8, 8},
                                           {"as if triangle.fill-rule=open", false, 1, 1}}));
}

TEST(Clusters, HaveNoCauseThatAnAnswerRefutes) {
  Results results = results_by({{kClosed, 10}});
  results.refuted["fake"]["window"].add(alternative_id(rule_named(kFill), "closed"));
  EXPECT_EQ(titles(clusters_of(results, 0)), Titles{"triangle.fill-rule=closed, fbo"});
  results.refuted["fake"]["fbo"].add(alternative_id(rule_named(kFill), "closed"));
  EXPECT_EQ(titles(clusters_of(results, 0)), Titles{"triangle.fill-rule extra, fbo"});
}

TEST(Clusters, HaveNoPairAsACauseFromOneCase) {
  const std::string pair = "triangle.snap=8-half-up + triangle.fill-rule=closed";
  EXPECT_EQ(titles(clusters_of(results_by({{pair, 1}}), 0)),
            Titles{"triangle.fill-rule extra, fbo"});
  EXPECT_EQ(titles(clusters_of(results_by({{pair, 2}}), 0)),
            Titles{"triangle.snap=8-half-up + triangle.fill-rule=closed, fbo"});
}

// A cause that fits as well elsewhere explains those cases, too.
TEST(Clusters, CountEveryCauseThatExplainsACase) {
  Results results = results_by({{kClosed, 3}, {kOpen, 2}});
  for (std::size_t i = 3; i < 5; ++i)
    edit(results.cases, i)->results[0].evidence = {
        {3, {cause_named(kOpen), cause_named(kClosed)}, {}, ""}};
  EXPECT_EQ(titles(clusters_of(results, 0)), Titles{"triangle.fill-rule=closed, fbo"});
  // The same of values, where evidence is about all of an answer.
  const auto of_values = [](const std::vector<std::string>& causes) {
    Result result;
    result.disagreements = {
        disagreement("stencil.test", DisagreementKind::value, false, causes.front(), "")};
    result.disagreements[0].primitive = -1;
    result.evidence.push_back({kAllValues, {}, {}, ""});
    for (const std::string& cause : causes) result.evidence[0].causes.push_back(cause_named(cause));
    CaseResults one = case_of("one", 1, 4, {});
    one.results = {result};
    return one;
  };
  std::vector<CaseResults> cases = {of_values({"stencil.test=ignored", "stencil.test=unmasked"}),
                                    of_values({"stencil.test=unmasked"})};
  cases[1].id = "other";
  EXPECT_EQ(titles(clusters_of(results_of(cases), 0)), Titles{"stencil.test=unmasked, fbo"});
  // What operations may come of explains no value that a fragment carries.
  cases[0].results[0].disagreements[0].primitive = 0;
  cases[0].results[0].disagreements[0].cause = {};
  EXPECT_EQ(titles(clusters_of(results_of(cases), 0)), Titles{"stencil.test value, fbo"});
}

TEST(Clusters, WithoutACauseTellWhatTheyHaveInCommon) {
  std::vector<CaseResults> cases;
  for (int i = 0; i < 5; ++i) {
    Disagreement d = unexplained(false, i == 0 ? "line, y-major right and up, beside the line"
                                               : "line, y-major left and down, beside the line");
    cases.push_back(case_of("case" + std::to_string(i), 1, 8, {d}));
  }
  const auto clusters = clusters_of(results_of(cases), 0);
  EXPECT_EQ(clusters[0].common,
            "beside the line, in the highest row, in the leftmost column, in the upper left "
            "quarter, y-major");
  cases.pop_back();
  EXPECT_EQ(clusters_of(results_of(cases), 0)[0].common, "") << "four may have much in common";
}

// An open choice that other answers refute explains a few by chance; one of most is a heading.
TEST(Clusters, OfAllowedDifferencesTellChoicesThatTheRendererMakes) {
  const auto allowed = [](const char* cause) {
    return disagreement(kLines, DisagreementKind::missing, true, cause, "");
  };
  Results results = results_of({case_of("a", 1, 4, {allowed("line.algorithm=bresenham")}),
                                case_of("b", 1, 4, {allowed("line.algorithm=midpoint")}),
                                case_of("c", 1, 4, {allowed("line.algorithm=midpoint")})});
  const Titles both = {"line.algorithm=midpoint, fbo", "line.algorithm=bresenham, fbo"};
  EXPECT_EQ(titles(clusters_of(results, 0)), both);
  for (const char* name : {"bresenham", "midpoint"})
    results.refuted["fake"]["fbo"].add(alternative_id(rule_named("line.algorithm"), name));
  const auto clusters = clusters_of(results, 0);
  EXPECT_EQ(titles(clusters),
            (Titles{"line.algorithm=midpoint, fbo", "line.diamond-exit missing, fbo"}));
  EXPECT_EQ(clusters[1].situations,
            (std::vector<ClusterSituation>{{"as if line.algorithm=bresenham", false, 1, 1}}));
}

TEST(Clusters, OfAnAnswerAreFoundByItsKey) {
  const Results results = results_by({{kClosed, 1}, {kOpen, 1}});
  const auto clusters = clusters_of(results, 0);
  for (const CaseResults& one : results.cases) {
    const auto key = leading_key(one, one.results[0]);
    ASSERT_TRUE(key);
    EXPECT_EQ(cluster_of(clusters, *key), &clusters[0]);
  }
  EXPECT_EQ(cluster_of(clusters, ClusterKey{}), nullptr);
}

TEST(Clusters, SurfacesAreNotMixed) {
  auto cases = {case_of("a", 1, 4, {unexplained(true, "s")}),
                case_of("b", 1, 4, {unexplained(true, "s"), unexplained(true, "s")})};
  Results results = results_of(cases);
  edit(results.cases, 1)->surface = "window";
  EXPECT_EQ(titles(clusters_of(results, 0)),
            (Titles{"line.diamond-exit missing, window", "line.diamond-exit missing, fbo"}));
}

// Whatever the numbers are: illegal, contested, legal; then the cases that share them.
TEST(Clusters, TheIllegalComeFirstThenTheContestedThenTheRest) {
  Disagreement contested =
      disagreement(kFill, DisagreementKind::extra, false, "line.snap=6-half-even", "");
  contested.legality = Legality::contested;
  const Disagreement legal =
      disagreement(kFill, DisagreementKind::extra, true, "line.snap=9-half-even", "");
  const Disagreement often =
      disagreement(kFill, DisagreementKind::extra, true, "line.snap=8-half-even", "");
  const Results results = results_of(
      {case_of("a", 1, 4, {legal, legal, legal, legal, often, contested, contested}),
       case_of("b", 1, 4, {often, contested, unexplained(false, "rare")}),
       case_of("c", 1, 4,
               {often,
                disagreement(kFill, DisagreementKind::extra, false, "line.snap=5-half-even", "")}),
       case_of(
           "d", 1, 4,
           {disagreement(kFill, DisagreementKind::extra, false, "line.snap=5-half-even", "")})});
  const auto clusters = clusters_of(results, 0);
  EXPECT_EQ(titles(clusters),
            (Titles{"line.snap=5-half-even, fbo", "line.diamond-exit missing, fbo",
                    "line.snap=6-half-even, fbo", "line.snap=8-half-even, fbo",
                    "line.snap=9-half-even, fbo"}));
  EXPECT_EQ(clusters[2].legality, Legality::contested);
  EXPECT_EQ(clusters[2].cases, 2U);
}

TEST(Clusters, OfAsManyCasesTheLargestComesFirst) {
  const auto explained = [](const char* cause, const char* rule = kFill) {
    return disagreement(rule, DisagreementKind::extra, false, cause, "");
  };
  Results results = results_of({case_of(
      "a", 1, 4,
      {explained("line.snap=5-half-even"), explained("line.snap=5-half-even"),
       explained("line.snap=5-half-even"), explained("line.snap=4-half-even", "point.ownership"),
       unexplained(true, "legal"), unexplained(true, "legal"), unexplained(true, "legal"),
       explained("line.snap=8-half-up", "line.joint"), unexplained(false, "z"),
       unexplained(false, "a")})});
  ValueAggregate values;
  values.attribute = "color";
  values.rule = rule_named("attribute.smooth");
  values.differing.resize(50);
  values.worst = {2, 3, 0};
  ValueAggregate none = values;
  none.attribute = "depth";
  none.differing.clear();
  ValueAggregate caused = values;
  caused.cause = cause_named("line.snap=6-half-even");
  caused.differing.resize(60);
  edit(results.cases, 0)->results[0].values = {values, none, caused};
  const auto clusters = clusters_of(results, 0);
  EXPECT_EQ(
      titles(clusters),
      (Titles{"line.snap=5-half-even, fbo", "line.diamond-exit missing, fbo",
              "line.snap=4-half-even, fbo", "line.snap=8-half-up, fbo",
              "line.snap=6-half-even, fbo", "attribute.smooth color within what is permitted, fbo",
              "line.diamond-exit missing, fbo"}));
  EXPECT_EQ(clusters[5].disagreements, 50U);
  EXPECT_EQ(clusters[5].x, 2);
  EXPECT_EQ(clusters[5].y, 3);
}

// Fewest primitives, then the smallest target, then the shortest id, then the first: each decides
// against all that come after it.
TEST(Clusters, TheSmallestCaseIsNamedWithItsFirstPixel) {
  const auto other = unexplained(true, "other", DisagreementKind::extra);
  const auto here = unexplained(true, "here");
  std::vector<CaseResults> cases = {
      case_of("a", 3, 2, {here}), case_of("aa", 2, 5, {here}), case_of("bbb", 2, 4, {here}),
      case_of("cc", 2, 4, {other, here, here}), case_of("dd", 2, 4, {here})};
  const auto smallest = [&] {
    const auto clusters = clusters_of(results_of(cases), 0);
    return *std::ranges::find(clusters, "missing", &Cluster::kind);
  };
  EXPECT_EQ(smallest().smallest_case, "cc");
  EXPECT_EQ(smallest().x, 1);
  EXPECT_EQ(smallest().y, 3);
  EXPECT_EQ(smallest().primitive, 3);
  EXPECT_EQ(smallest().cases, 5U);
  cases.erase(cases.begin() + 3);
  EXPECT_EQ(smallest().smallest_case, "dd");
  cases.pop_back();
  EXPECT_EQ(smallest().smallest_case, "bbb");
  cases.pop_back();
  EXPECT_EQ(smallest().smallest_case, "aa");
  cases.pop_back();
  EXPECT_EQ(smallest().smallest_case, "a");
}

TEST(Clusters, EveryDisagreementIsInOneCluster) {
  const Results results = full_results();
  for (std::size_t r = 0; r < results.renderers.size(); ++r) {
    std::size_t all = 0;
    for (const CaseResults& one : results.cases) {
      all += one.results[r].disagreements.size();
      for (const ValueAggregate& values : one.results[r].values) all += values.differing.size();
    }
    std::size_t gathered = 0;
    for (const Cluster& cluster : clusters_of(results, r)) gathered += cluster.disagreements;
    EXPECT_EQ(gathered, all);
    EXPECT_GT(gathered, 0U);
  }
}

TEST(Clusters, StandInTheResultsFile) {
  const Results results = results_of(
      {case_of("lines/a", 1, 4,
               {unexplained(false, "first pixel"), unexplained(false, "last pixel"),
                unexplained(false, "last pixel"),
                disagreement(kFill, DisagreementKind::extra, true, "line.snap=7-half-even", "")})});
  std::ostringstream out;
  write_results(results, out);
  const auto clusters =
      nlohmann::json::parse(out.str().substr(out.str().find("{\"end\""))).at("clusters");
  EXPECT_EQ(clusters, nlohmann::json::parse(R"({"fake": [
    {"rule": "line.diamond-exit", "kind": "missing", "surface": "fbo",
     "legality": "illegal", "disagreements": 3, "cases": 1,
     "situations": [["last pixel", 2, 1], ["first pixel", 1, 1]],
     "smallest": {"case": "lines/a", "pixel": [0, 3], "primitive": 3}},
    {"cause": "line.snap=7-half-even", "rule": "triangle.fill-rule", "kind": "extra", "surface": "fbo",
     "legality": "legal", "disagreements": 1, "cases": 1,
     "smallest": {"case": "lines/a", "pixel": [3, 3], "primitive": 3}}]})"));
}

}  // namespace
}  // namespace edgecase
