// SPDX-License-Identifier: MIT
//
// What measurement adds to the core: the first case of what no listed case shows.
#include "suite/core_suite.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace edgecase {
namespace {

Result answer(Verdict verdict, const std::vector<std::string>& faults = {}) {
  Result result;
  result.verdict = verdict;
  result.faults = faults;
  return result;
}

Results results_of(const std::vector<std::pair<std::string, std::vector<Result>>>& answers) {
  Results results;
  results.renderers.resize(2);
  for (const auto& [id, given] : answers) {
    CaseResults one;
    one.id = id;
    one.results = given;
    results.cases.push_back(one);
  }
  return results;
}

const Result kAgrees = answer(Verdict::agree);

TEST(CoreSuite, TheFirstCaseOfEachFaultOfEachRendererIsAdded) {
  const Results results = results_of({{"a", {answer(Verdict::violation, {"hole"}), kAgrees}},
                                      {"b", {answer(Verdict::violation, {"hole", "far"}), kAgrees}},
                                      {"c", {kAgrees, answer(Verdict::violation, {"hole"})}},
                                      {"d", {kAgrees, answer(Verdict::violation, {"hole"})}}});
  std::vector<std::string> ids;
  EXPECT_EQ(add_shown(results, ids), 3u);
  EXPECT_EQ(ids, (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(add_shown(results, ids), 0u);
}

TEST(CoreSuite, WhatAListedCaseShowsAddsNone) {
  const Results results = results_of({{"a", {answer(Verdict::violation, {"hole"}), kAgrees}},
                                      {"b", {answer(Verdict::violation, {"hole"}), kAgrees}}});
  std::vector<std::string> ids = {"b", "z"};
  EXPECT_EQ(add_shown(results, ids), 0u);
  EXPECT_EQ(ids, (std::vector<std::string>{"b", "z"}));
}

// One case for all that is not known yet; what is contested is no crime.
TEST(CoreSuite, AViolationWithoutAKnownFaultIsAdded) {
  const Results results = results_of({{"a", {answer(Verdict::contested), kAgrees}},
                                      {"b", {answer(Verdict::violation), kAgrees}},
                                      {"c", {answer(Verdict::violation), kAgrees}}});
  std::vector<std::string> ids;
  EXPECT_EQ(add_shown(results, ids), 1u);
  EXPECT_EQ(ids, (std::vector<std::string>{"b"}));
}

}  // namespace
}  // namespace edgecase
