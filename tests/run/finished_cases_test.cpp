// SPDX-License-Identifier: MIT
//
// A run tells of each case when all renderers have answered it, and before of the renderers.
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <map>
#include <string>

#include "run/run.h"

namespace edgecase {
namespace {

class Told final : public FinishedCases {
 public:
  void hold(const Results&) override { ADD_FAILURE() << "nothing is gone on with"; }
  void begin(const Results& run) override {
    const Alone alone(busy_);
    EXPECT_TRUE(run.cases.empty());
    known_ = run;
  }
  void add(const CaseResults& one) override {
    const Alone alone(busy_);
    ASSERT_EQ(known_.renderers.size(), one.results.size());
    for (const RendererInfo& info : known_.renderers) EXPECT_NE(info.device, "") << info.name;
    EXPECT_TRUE(cases_.emplace(one.id, one).second) << one.id << " is told of twice";
  }

  Results known_;
  std::map<std::string, CaseResults> cases_;

 private:
  struct Alone {
    explicit Alone(std::atomic<bool>& flag) : busy(flag) { EXPECT_FALSE(busy.exchange(true)); }
    ~Alone() { busy = false; }
    std::atomic<bool>& busy;
  };
  std::atomic<bool> busy_ = false;
};

TEST(FinishedCases, AreToldOnceEachAndAsTheResultsHaveThem) {
  Selection selection;
  selection.paths = {std::filesystem::path(EDGECASE_ROOT) / "cases/lines/diamonds"};
  const Suite suite = load_suite(selection);
  ASSERT_GT(suite.cases.size(), 10U);
  Told told;
  RunOptions options;
  options.renderers = {"exact", "other=exact"};
  options.renderer_options.policy = options.policy;
  options.jobs = 3;
  options.finished = &told;
  const Results results = run_suite(suite, options).results;
  ASSERT_EQ(told.known_.renderers.size(), results.renderers.size());
  for (std::size_t r = 0; r < results.renderers.size(); ++r)
    EXPECT_EQ(told.known_.renderers[r].name, results.renderers[r].name);
  EXPECT_EQ(told.known_.policy_digest, results.policy_digest);
  ASSERT_EQ(told.cases_.size(), results.cases.size());
  for (const CaseResults& one : results.cases) {
    const CaseResults& found = told.cases_.at(one.id);
    EXPECT_EQ(found.file_digest, one.file_digest);
    EXPECT_EQ(found.fragments, one.fragments);
    for (std::size_t r = 0; r < one.results.size(); ++r)
      EXPECT_EQ(found.results[r].answer_digest, one.results[r].answer_digest);
  }
}

}  // namespace
}  // namespace edgecase
