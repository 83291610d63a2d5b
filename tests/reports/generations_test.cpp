// SPDX-License-Identifier: MIT
//
// Known faults against the releases of a driver, as results tell and as a table shows them.
#include "results/generations.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <vector>

#include "reports/generations_markdown.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

struct Seen {
  const char* renderer;
  const char* fault;
  std::size_t cases;
};

// A whole run of llvmpipe through two front ends, in which so many cases were unexpected.
Results run_of(const std::string& version, const std::vector<Seen>& seen,
               std::size_t unexpected = 0) {
  Results results;
  results.whole_suite = true;
  for (const char* name : {"osmesa:llvmpipe", "egl:llvmpipe"})
    results.renderers.push_back({name,
                                 "Mesa",
                                 "4.5 (Core Profile) Mesa " + version,
                                 "llvmpipe (LLVM 15.0.6, 256 bits)",
                                 8,
                                 {}});
  for (const Seen& one : seen)
    results.faults.push_back({one.renderer, one.fault, std::string("In ") + version, "", one.cases,
                              std::nullopt, FaultState::known});
  for (std::size_t i = 0; i < unexpected; ++i) {
    CaseResults one;
    one.results.resize(2);
    one.results[1].standing = Standing::unexpected;
    results.cases.push_back(one);
  }
  return results;
}

// Newest first, which is not the order of the table.
Generations three_releases() {
  Generations generations;
  for (const Results& results :
       {run_of("26.2.6", {{"egl:llvmpipe", "began", 4}, {"egl:llvmpipe", "always", 1}}, 2),
        run_of("25.0.7", {{"egl:llvmpipe", "between", 7},
                          {"egl:llvmpipe", "always", 2},
                          {"egl:llvmpipe", "began", 4},
                          {"egl:llvmpipe", "ended", 0}}),
        run_of("22.3.6", {{"osmesa:llvmpipe", "always", 5},
                          {"egl:llvmpipe", "always", 3},
                          {"egl:llvmpipe", "ended", 6}})})
    EXPECT_EQ(add_generation(generations, results), std::nullopt);
  return generations;
}

TEST(Generations, HoldReleasesInTheirOrderAndTheMostCasesOfEach) {
  const Generations generations = three_releases();
  ASSERT_EQ(generations.size(), 1u);
  const DriverGenerations& driver = generations.at("llvmpipe");
  std::vector<std::string> releases;
  for (const Release& release : driver.releases) releases.push_back(text_of(release));
  EXPECT_THAT(releases, ElementsAre("Mesa 22.3.6", "Mesa 25.0.7", "Mesa 26.2.6"));
  EXPECT_THAT(driver.faults.at("always"),
              ElementsAre(Pair("Mesa 22.3.6", 5), Pair("Mesa 25.0.7", 2), Pair("Mesa 26.2.6", 1)));
  EXPECT_THAT(driver.faults.at("ended"), ElementsAre(Pair("Mesa 22.3.6", 6)));
  EXPECT_EQ(driver.unexpected.at("Mesa 26.2.6"), 2u);
  EXPECT_EQ(driver.reasons.at("always"), "In 26.2.6");
  EXPECT_EQ(driver.reasons.at("ended"), "In 22.3.6");
}

TEST(Generations, TellTheFirstAndTheLastReleaseOfEachFault) {
  const std::string text = generations_markdown(three_releases());
  EXPECT_THAT(text, HasSubstr("| fault | `Mesa 22.3.6` | `Mesa 25.0.7` | `Mesa 26.2.6` | seen |"));
  EXPECT_THAT(text, HasSubstr("| `always` | 5 | 2 | 1 | all | `In 26.2.6` |"));
  EXPECT_THAT(text, HasSubstr("| `began` | 0 | 4 | 4 | since Mesa 25.0.7 | `In 26.2.6` |"));
  EXPECT_THAT(text, HasSubstr("| `between` | 0 | 7 | 0 | Mesa 25.0.7 alone | `In 25.0.7` |"));
  EXPECT_THAT(text, HasSubstr("| `ended` | 6 | 0 | 0 | until Mesa 22.3.6 | `In 22.3.6` |"));
  EXPECT_THAT(text, HasSubstr("| not known | 0 | 0 | 2 | since Mesa 26.2.6 |  |"));
}

TEST(Generations, TellRulesThatReleasesFollowOtherwise) {
  const auto following = [](const std::string& version, std::size_t rounded) {
    Results results = run_of(version, {});
    RuleAnswers snap{RuleId::line_snap, 20, {}};
    snap.against.assign(rule_of(RuleId::line_snap).alternatives.size(), 20);
    snap.against[0] = 20 - rounded;
    snap.against[1] = rounded;
    results.rules["egl:llvmpipe"]["fbo"] = {
        snap,
        {RuleId::depth_test, 1,
         std::vector<std::size_t>(rule_of(RuleId::depth_test).alternatives.size(), 0)}};
    return results;
  };
  Generations generations;
  add_generation(generations, following("22.3.6", 20));
  add_generation(generations, following("25.0.7", 0));
  const auto& alternatives = rule_of(RuleId::line_snap).alternatives;
  const std::string told = fmt::format("line.snap, fbo: {} on Mesa 22.3.6, {} on Mesa 25.0.7",
                                       alternatives[0].name, alternatives[1].name);
  EXPECT_THAT(changed_rules(generations.at("llvmpipe")), ElementsAre(told));
  EXPECT_THAT(generations_text(generations), HasSubstr("  " + told + "\n"));
  EXPECT_THAT(generations_markdown(generations), HasSubstr("- `" + told + "`\n"));
}

TEST(Generations, StandInColumnsForATerminal) {
  EXPECT_EQ(generations_text(three_releases()),
            "llvmpipe\n"
            "  fault      Mesa 22.3.6  Mesa 25.0.7  Mesa 26.2.6  seen\n"
            "  always               5            2            1  all\n"
            "  began                0            4            4  since Mesa 25.0.7\n"
            "  between              0            7            0  Mesa 25.0.7 alone\n"
            "  ended                6            0            0  until Mesa 22.3.6\n"
            "  not known            0            0            2  since Mesa 26.2.6\n");
}

TEST(Generations, RefuseResultsThatAreNotWhole) {
  Generations generations;
  Results results = run_of("22.3.6", {});
  results.whole_suite = false;
  EXPECT_THAT(add_generation(generations, results).value_or(""), HasSubstr("whole suite"));
  EXPECT_TRUE(generations.empty());
}

}  // namespace
}  // namespace edgecase
