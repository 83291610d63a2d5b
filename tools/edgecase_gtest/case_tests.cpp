// SPDX-License-Identifier: MIT
#include "tools/edgecase_gtest/case_tests.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "reports/test_outcomes.h"
#include "reports/text.h"
#include "tools/edgecase_gtest/test_names.h"

namespace edgecase {
namespace {

struct Answer {
  TestStatus status = TestStatus::passed;
  std::string text;  // a message; may be empty
};

// The run behind the tests, which is done once each time that GoogleTest runs them.
class CaseRun final : public testing::Environment {
 public:
  explicit CaseRun(CaseTests tests) : tests_(std::move(tests)) {}

  const CaseStore& cases() const { return tests_.suite.cases; }
  const std::vector<Diagnostic>& diagnostics() const { return tests_.suite.diagnostics; }
  const std::vector<std::string>& renderers() const { return tests_.run.renderers; }

  // Records the case and renderer of a test.
  void add(const std::string& name, std::size_t renderer, std::size_t index) {
    places_[name] = {renderer, index};
  }

  // Null if the run did not reach it.
  const Answer* find(std::size_t renderer, std::size_t index) const {
    const auto found = answers_.find({renderer, cases().id(index)});
    return found == answers_.end() ? nullptr : &found->second;
  }

  // Renderers with the same selected cases share a run.
  void SetUp() override {
    answers_.clear();
    std::map<std::set<std::size_t>, std::vector<std::size_t>> runs;
    const auto asked = selected_cases();
    for (std::size_t r = 0; r < asked.size(); ++r)
      if (!asked[r].empty()) runs[asked[r]].push_back(r);
    for (const auto& [indices, renderers] : runs) run(indices, renderers);
  }

 private:
  // By renderer: the cases whose tests GoogleTest is about to run.
  std::vector<std::set<std::size_t>> selected_cases() const {
    std::vector<std::set<std::size_t>> selected(renderers().size());
    const testing::UnitTest& program = *testing::UnitTest::GetInstance();
    for (int s = 0; s < program.total_test_suite_count(); ++s) {
      const testing::TestSuite& suite = *program.GetTestSuite(s);
      for (int t = 0; t < suite.total_test_count(); ++t) {
        const testing::TestInfo& test = *suite.GetTestInfo(t);
        const auto place = places_.find(fmt::format("{}.{}", suite.name(), test.name()));
        if (test.should_run() && place != places_.end())
          selected[place->second.first].insert(place->second.second);
      }
    }
    return selected;
  }

  void run(const std::set<std::size_t>& indices, const std::vector<std::size_t>& renderers) {
    Suite suite;
    for (const std::size_t i : indices) suite.cases.push_back(cases()[i]);
    RunOptions options = tests_.run;
    options.renderers.clear();
    for (const std::size_t r : renderers) options.renderers.push_back(tests_.run.renderers[r]);
    const auto ran = run_judged(suite, options, tests_.progress);
    if (!ran) return;
    visit_outcomes(ran->results, [&](const TestOutcome& outcome) {
      if (outcome.result == nullptr) return;
      std::size_t r = 0;
      while (&outcome.one->results[r] != outcome.result) ++r;
      take(outcome, outcome.one->results[r], answers_[{renderers[r], outcome.one->id}]);
    });
  }

  static void take(const TestOutcome& outcome, const Result& result, Answer& answer) {
    answer.status = outcome.status;
    if (!outcome.message.empty()) answer.text = outcome.message + "\n" + outcome.details;
    if (result.standing == Standing::known)
      answer.text = "known fault: " + one_line(result.standing_reason) + "\n";
    // Hand-drawn expectations that exact does not meet.
    for (const std::string& failure : outcome.one->expect_failures) {
      answer.status = std::max(answer.status, TestStatus::failed);
      answer.text += xml_text(failure) + "\n";
    }
  }

  using Place = std::pair<std::size_t, std::size_t>;  // renderer, case

  CaseTests tests_;
  std::map<std::string, Place> places_;                            // by the test's full name
  std::map<std::pair<std::size_t, std::string>, Answer> answers_;  // by renderer and id
};

class CaseTest : public testing::Test {
 public:
  CaseTest(const CaseRun& run, std::size_t renderer, std::size_t index)
      : run_(run), renderer_(renderer), index_(index) {}

  void TestBody() override {
    const Case one = run_.cases()[index_];
    RecordProperty("id", one_line(one.id));
    const Answer* answer = run_.find(renderer_, index_);
    if (answer == nullptr) FAIL() << one_line(one.id) << " was not drawn: the run ended before it";
    if (answer->status == TestStatus::skipped) GTEST_SKIP() << answer->text;
    if (answer->status == TestStatus::passed)
      fmt::print("{}", answer->text);
    else
      ADD_FAILURE_AT(one.file.string().c_str(), 1)
          << one_line(one.id) << ", " << one_line(run_.renderers()[renderer_]) << ": "
          << answer->text;
  }

 private:
  const CaseRun& run_;
  std::size_t renderer_;
  std::size_t index_;
};

// A case file that cannot be loaded.
class FileTest : public testing::Test {
 public:
  explicit FileTest(std::vector<Diagnostic> diagnostics) : diagnostics_(std::move(diagnostics)) {}

  void TestBody() override {
    for (const Diagnostic& diagnostic : diagnostics_)
      ADD_FAILURE_AT(diagnostic.file.c_str(), std::max(1, diagnostic.line))
          << one_line(to_string(diagnostic));
  }

 private:
  std::vector<Diagnostic> diagnostics_;
};

// Makes names unique: if two ids have the same name, the second gets a number.
std::string unique(const std::string& suite, std::string test, std::set<std::string>& names) {
  const std::string name = test;
  for (int n = 2; !names.insert(suite + "." + test).second; ++n)
    test = fmt::format("{}_{}", name, n);
  return test;
}

}  // namespace

std::vector<std::string> suite_prefixes(const std::vector<std::string>& renderers) {
  std::vector<std::string> prefixes;
  for (const std::string& renderer : renderers)
    prefixes.push_back(renderers.size() == 1 ? "" : name_text(renderer) + "/");
  return prefixes;
}

void register_case_tests(CaseTests tests) {
  auto owned = std::make_unique<CaseRun>(std::move(tests));
  CaseRun& run = *owned;
  std::set<std::string> names;
  const auto prefixes = suite_prefixes(run.renderers());
  for (std::size_t r = 0; r < prefixes.size(); ++r)
    for (std::size_t i = 0; i < run.cases().size(); ++i) {
      const Case one = run.cases()[i];
      TestName name = test_name_of(prefixes[r], one.id);
      name.test = unique(name.suite, name.test, names);
      run.add(name.suite + "." + name.test, r, i);
      testing::RegisterTest(name.suite.c_str(), name.test.c_str(), nullptr, nullptr,
                            one.file.string().c_str(), 1,
                            [&run, r, i]() -> testing::Test* { return new CaseTest(run, r, i); });
    }
  std::map<std::string, std::vector<Diagnostic>> files;
  for (const Diagnostic& diagnostic : run.diagnostics())
    files[diagnostic.file].push_back(diagnostic);
  for (const auto& [file, diagnostics] : files) {
    const std::string test = unique(kFilesSuite, name_text(file), names);
    testing::RegisterTest(
        kFilesSuite, test.c_str(), nullptr, nullptr, file.c_str(), 1,
        [diagnostics = diagnostics]() -> testing::Test* { return new FileTest(diagnostics); });
  }
  testing::AddGlobalTestEnvironment(owned.release());
}

}  // namespace edgecase
