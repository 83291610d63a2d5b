// SPDX-License-Identifier: MIT
//
// The order in which people are told what a run found.
#include "results/worst_first.h"
#include "tests/support/causes.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace edgecase {
namespace {

Disagreement difference(int x, Legality legality, const std::string& cause = "") {
  Disagreement d;
  d.x = x;
  d.rule = rule_named("triangle.fill-rule");
  d.legality = legality;
  d.cause = cause_named(cause);
  return d;
}

Result answer(Verdict verdict, std::vector<Disagreement> disagreements) {
  Result result;
  result.verdict = verdict;
  result.disagreements = std::move(disagreements);
  return result;
}

Results results_of(const std::vector<Result>& answers) {
  Results results;
  results.renderers.resize(1);
  for (const Result& answer : answers) {
    CaseResults one;
    one.results = {answer};
    results.cases.push_back(one);
  }
  return results;
}

std::vector<std::size_t> order_of(const Results& results) {
  std::vector<std::size_t> order;
  for (const AnswerPlace& place : worst_first(results, [](const ResultOutline&) { return true; }))
    order.push_back(place.one);
  return order;
}

using Order = std::vector<std::size_t>;

TEST(WorstFirst, OfACaseTheIllegalThenTheContestedThenTheLegal) {
  const Result result = answer(Verdict::violation,
                               {difference(0, Legality::legal), difference(1, Legality::contested),
                                difference(2, Legality::illegal), difference(3, Legality::legal),
                                difference(4, Legality::illegal)});
  std::vector<int> columns;
  for (const Disagreement* d : worst_first(result)) columns.push_back(d->x);
  EXPECT_EQ(columns, (std::vector{2, 4, 1, 0, 3}));
}

TEST(WorstFirst, OfARunByVerdict) {
  EXPECT_EQ(order_of(results_of(
                {answer(Verdict::not_run, {}), answer(Verdict::agree, {}),
                 answer(Verdict::convention, {difference(0, Legality::legal, "line.snap=none")}),
                 answer(Verdict::permitted, {difference(0, Legality::legal)}),
                 answer(Verdict::contested, {difference(0, Legality::contested)}),
                 answer(Verdict::violation, {difference(0, Legality::illegal)})})),
            (Order{5, 4, 3, 2, 1, 0}));
}

// What is legal beside a violation does not decide what the answer begins with.
TEST(WorstFirst, OfOneVerdictByHowManyCasesShareTheCause) {
  const auto violation = [](const std::string& cause) {
    return answer(Verdict::violation, {difference(0, Legality::legal, "line.snap=none"),
                                       difference(1, Legality::illegal, cause)});
  };
  EXPECT_EQ(
      order_of(results_of({violation("line.snap=4-truncate"), violation("line.snap=8-truncate"),
                           violation(""), violation("line.snap=8-truncate"),
                           violation("line.snap=8-truncate"), violation("")})),
      (Order{1, 3, 4, 2, 5, 0}));
}

TEST(WorstFirst, OnlyWhatIsWanted) {
  Results results = results_of({answer(Verdict::violation, {}), answer(Verdict::contested, {})});
  results.cases.answer(1, 0).standing = Standing::tolerated;
  const auto places = worst_first(
      results, [](const ResultOutline& answer) { return answer.standing == Standing::tolerated; });
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].one, 1U);
}

}  // namespace
}  // namespace edgecase
