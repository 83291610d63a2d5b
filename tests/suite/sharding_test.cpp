// SPDX-License-Identifier: MIT
//
// Which share of the cases a CI system's variables ask for, and which cases a share has.
#include "suite/sharding.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

#include "casefile/loader.h"

namespace edgecase {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

using Variables = std::map<std::string, std::string>;

auto choice_of(const Variables& variables) {
  return shard_of_variables([&](const char* name) {
    const auto found = variables.find(name);
    return found != variables.end() ? found->second.c_str() : nullptr;
  });
}

// "I/N by VARIABLES", "all", or the complaint.
std::string words(const Variables& variables) {
  const auto outcome = choice_of(variables);
  if (const auto* fault = std::get_if<std::string>(&outcome)) return *fault;
  const auto& choice = std::get<ShardChoice>(outcome);
  if (choice.source.empty()) return choice.shard.count == 1 ? "all" : "a shard of nobody";
  return std::to_string(choice.shard.index + 1) + "/" + std::to_string(choice.shard.count) +
         " by " + choice.source;
}

Variables bazel(const std::string& total, const std::string& index) {
  return {{"TEST_TOTAL_SHARDS", total}, {"TEST_SHARD_INDEX", index}};
}

Variables gitlab(const std::string& total, const std::string& index) {
  return {{"CI_NODE_TOTAL", total}, {"CI_NODE_INDEX", index}};
}

Variables both(Variables a, const Variables& b) {
  a.insert(b.begin(), b.end());
  return a;
}

TEST(ShardOfVariables, BazelCountsFrom0AndGitLabFrom1) {
  EXPECT_EQ(words(bazel("3", "0")), "1/3 by TEST_TOTAL_SHARDS and TEST_SHARD_INDEX");
  EXPECT_EQ(words(bazel("3", "2")), "3/3 by TEST_TOTAL_SHARDS and TEST_SHARD_INDEX");
  EXPECT_EQ(words(gitlab("3", "1")), "1/3 by CI_NODE_TOTAL and CI_NODE_INDEX");
  EXPECT_EQ(words(gitlab("3", "3")), "3/3 by CI_NODE_TOTAL and CI_NODE_INDEX");
}

TEST(ShardOfVariables, AJobThatIsNotDividedHasAllCases) {
  EXPECT_EQ(words({}), "all");
  EXPECT_EQ(words(bazel("", "")), "all");
  EXPECT_EQ(words({{"CI_NODE_TOTAL", "1"}}), "all") << "as GitLab sets it everywhere";
  EXPECT_EQ(words(gitlab("1", "1")), "all");
  EXPECT_EQ(words(bazel("1", "0")), "all");
  EXPECT_THAT(words(both(bazel("4", "1"), {{"CI_NODE_TOTAL", "1"}})), StartsWith("2/4 by TEST_"));
}

TEST(ShardOfVariables, BothMayAgreeAndMustNotDisagree) {
  EXPECT_THAT(words(both(bazel("4", "1"), gitlab("4", "2"))), StartsWith("2/4 by "));
  for (const Variables& other : {gitlab("4", "1"), gitlab("5", "2")})
    EXPECT_THAT(words(both(bazel("4", "1"), other)),
                AllOf(HasSubstr("TEST_TOTAL_SHARDS"), HasSubstr("CI_NODE_TOTAL"),
                      HasSubstr("ask for shard 2/4")));
}

TEST(ShardOfVariables, WhatIsMissingOrMalformedIsNamed) {
  EXPECT_THAT(words({{"TEST_TOTAL_SHARDS", "4"}}), HasSubstr("TEST_SHARD_INDEX is not"));
  EXPECT_THAT(words({{"TEST_SHARD_INDEX", "0"}}), HasSubstr("TEST_TOTAL_SHARDS is not"));
  EXPECT_THAT(words({{"CI_NODE_TOTAL", "4"}}), HasSubstr("CI_NODE_INDEX is not"));
  EXPECT_THAT(words({{"CI_NODE_INDEX", "1"}}), HasSubstr("CI_NODE_TOTAL is not"));
  for (const char* bad : {"x", "4x", " 4", "-1", "0", "4.0", "99999999999"}) {
    EXPECT_THAT(words(bazel(bad, "0")), StartsWith("TEST_TOTAL_SHARDS is \"")) << bad;
    EXPECT_THAT(words(gitlab(bad, "1")), StartsWith("CI_NODE_TOTAL is \"")) << bad;
  }
  for (const char* bad : {"4", "-1", "x"})
    EXPECT_THAT(words(bazel("4", bad)), HasSubstr("set it to a number from 0 to 3")) << bad;
  for (const char* bad : {"0", "5", "x"})
    EXPECT_THAT(words(gitlab("4", bad)), HasSubstr("set it to a number from 1 to 4")) << bad;
}

TEST(ParseShard, CountsFrom1) {
  EXPECT_EQ(parse_shard("2/3")->index, 1);
  EXPECT_EQ(parse_shard("2/3")->count, 3);
  for (const char* bad : {"", "2", "0/3", "4/3", "1/0", "a/3", "1/b", "1/3/5", "-1/3"})
    EXPECT_FALSE(parse_shard(bad)) << bad;
}

// Costs that differ a hundredfold, most of them small.
std::vector<double> uneven_costs(std::size_t count) {
  std::mt19937 random(7);
  std::vector<double> costs;
  for (std::size_t i = 0; i < count; ++i)
    costs.push_back(random() % 97 == 0 ? 100.0 : static_cast<double>(1 + random() % 5));
  return costs;
}

TEST(Shards, HaveEachCaseOnceAndCostTheSame) {
  for (const std::size_t size : {0U, 1U, 5U, 31U, 2000U})
    for (const std::size_t count : {1U, 2U, 3U, 7U, 40U, 3000U}) {
      SCOPED_TRACE(std::to_string(size) + " cases, " + std::to_string(count) + " shards");
      const std::vector<double> costs = uneven_costs(size);
      std::vector<std::size_t> first = first_of_shards(costs, count);
      ASSERT_EQ(first.size(), count);
      EXPECT_EQ(first.front(), 0U);
      EXPECT_TRUE(std::ranges::is_sorted(first));
      EXPECT_LE(first.back(), size);
      first.push_back(size);
      const double mean =
          std::accumulate(costs.begin(), costs.end(), 0.0) / static_cast<double>(count);
      for (std::size_t i = 0; i < count; ++i) {
        // None is empty while there are cases.
        EXPECT_EQ(first[i] < first[i + 1], i < size);
        const auto at = [&](std::size_t index) {
          return costs.begin() + static_cast<std::ptrdiff_t>(index);
        };
        if (size < 20 * count) continue;
        const double cost = std::accumulate(at(first[i]), at(first[i + 1]), 0.0);
        EXPECT_NEAR(cost, mean, 100);
      }
    }
}

double cost_in(const std::string& id) {
  const auto file = std::filesystem::path(EDGECASE_ROOT) / "cases" / (id + ".json");
  return cost_of(load_cases(file, id).cases.front().scene);
}

TEST(Shards, KnowWhatIsExpensive) {
  EXPECT_NEAR(cost_in("triangles/single/one-pixel-target"), 1, 0.1);
  EXPECT_GT(cost_in("output/offset/clamp"), 4);
  EXPECT_GT(cost_in("textures/mipmaps/odd-sizes"), 20);
  EXPECT_GT(cost_in("textures/anisotropy/texels"), 10);
  EXPECT_GT(cost_in("values/derivatives/linear"), 5);
  EXPECT_GT(cost_in("samples/supersampling/moire-of-a-floor"), 20);
}

}  // namespace
}  // namespace edgecase
