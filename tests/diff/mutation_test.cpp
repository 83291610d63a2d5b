// SPDX-License-Identifier: MIT
//
// Every mutant on each of its scenes, twice: by itself, and as the one wrong answer of a run in
// which all other scenes are drawn right.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

#include "diff/compare.h"
#include "diff/judge.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "tests/diff/mutants.h"
#include "tests/diff/named_scenes.h"

namespace edgecase {
namespace {

constexpr int kReportedBits = 8;

std::vector<std::string> scenes_of(const Mutant& mutant) {
  if (!mutant.scenes.empty()) return mutant.scenes;
  std::vector<std::string> names;
  for (const NamedScene& one : named_scenes()) names.push_back(one.name);
  return names;
}

// Judges `wrong` in a run with the right answers to all other scenes.
Result judged_in_a_run(const std::string& name, const Result& wrong) {
  static const std::map<std::string, Result> right = [] {
    std::map<std::string, Result> results;
    for (const NamedScene& one : named_scenes()) {
      const Rendering exact = rasterize(one.scene, {});
      results[one.name] = compare(one.scene, {}, exact, exact, kReportedBits);
    }
    return results;
  }();
  std::map<std::string, Result> run = right;
  run[name] = wrong;
  std::vector<Result*> pointers;
  for (auto& [id, result] : run) pointers.push_back(&result);
  judge(pointers, Latitude::opengl);
  for (const auto& [id, result] : run) {
    EXPECT_TRUE(id == name || result.verdict == Verdict::agree) << id;
  }
  return run[name];
}

// The first few disagreements and all aggregates.
std::string describe(const Result& result) {
  std::string text = std::string("verdict ") + name_of(result.verdict) + "\n";
  for (std::size_t i = 0; i < std::min<std::size_t>(3, result.disagreements.size()); ++i) {
    const Disagreement& d = result.disagreements[i];
    text += std::string(name_of(d.kind)) + " " + d.rule + (d.legal ? " legal" : " illegal") +
            " cause '" + d.cause + "': " + d.explanation + "\n";
  }
  for (const ValueAggregate& v : result.values)
    text += v.attribute + " " + v.rule + " differs at " + std::to_string(v.differing.size()) + "\n";
  return text;
}

// Whether the cause that was chosen must be the mutant's, or only one that draws the same: where
// all other scenes are drawn right, they speak against every alternative, and the one that they
// speak against least is chosen.
enum class CauseMustBe { the_mutants, one_that_reproduces };

bool reproduces(const Result& result, const Disagreement& d, const std::string& cause) {
  for (const Result::Evidence& evidence : result.evidence)
    if (evidence.primitive == d.primitive)
      return std::find(evidence.causes.begin(), evidence.causes.end(), cause) !=
             evidence.causes.end();
  return d.cause == cause;
}

void expect_as_the_mutant_says(const Mutant& mutant, const Result& result, CauseMustBe must_be) {
  EXPECT_STREQ(name_of(result.verdict), name_of(mutant.verdict)) << describe(result);
  EXPECT_FALSE(result.fingerprint.empty());
  std::set<std::string> rules;
  for (const Disagreement& d : result.disagreements) {
    rules.insert(d.rule);
    EXPECT_FALSE(d.explanation.empty());
    EXPECT_NE(find_rule(d.rule), nullptr) << d.rule;
    EXPECT_NE(find_ruling(d.ruling), nullptr) << d.rule << " " << d.ruling;
    const bool has_cause = d.kind != DisagreementKind::value || d.rule == "attribute.flat";
    if (!has_cause || mutant.cause == kAnyCause) continue;
    if (must_be == CauseMustBe::the_mutants || mutant.cause.empty()) {
      EXPECT_EQ(d.cause, mutant.cause) << describe(result);
    } else {
      EXPECT_TRUE(reproduces(result, d, mutant.cause)) << describe(result);
      EXPECT_TRUE(reproduces(result, d, d.cause)) << describe(result);
    }
  }
  EXPECT_TRUE(mutant.rule.empty() || rules.count(mutant.rule) == 1) << describe(result);
}

int check(const std::vector<Mutant>& mutants) {
  int applied = 0;
  for (const Mutant& mutant : mutants)
    for (const std::string& name : scenes_of(mutant)) {
      SCOPED_TRACE(mutant.name + " / " + name);
      const Scene& scene = scene_named(name);
      const Rendering exact = rasterize(scene, {});
      const Rendering wrong = mutant.mutate(scene, exact);
      Result result = compare(scene, {}, exact, wrong, kReportedBits);
      ++applied;
      EXPECT_TRUE(!result.disagreements.empty() || !result.values.empty());
      expect_as_the_mutant_says(mutant, judged_in_a_run(name, result),
                                CauseMustBe::one_that_reproduces);
      Result* const alone[] = {&result};
      judge(alone, Latitude::opengl);
      expect_as_the_mutant_says(mutant, result, CauseMustBe::the_mutants);
      judge(alone, Latitude::none);
      EXPECT_EQ(result.verdict, Verdict::violation) << "without latitude every difference is one";
    }
  std::printf("%zu mutants, %d wrong renderings\n", mutants.size(), applied);
  return applied;
}

TEST(Mutants, OfAnyScene) {
  EXPECT_GT(check(general_mutants()), 100);
}
TEST(Mutants, OfLines) {
  EXPECT_GT(check(line_mutants()), 50);
}
TEST(Mutants, OfTrianglesAndPoints) {
  EXPECT_GT(check(area_mutants()), 20);
}
TEST(Mutants, OfAlternatives) {
  EXPECT_GT(check(alternative_mutants()), 10);
}
TEST(Mutants, OfValues) {
  EXPECT_GT(check(value_mutants()), 20);
}
TEST(Mutants, OfPixels) {
  EXPECT_GT(check(pixel_mutants()), 20);
}

// The scenes themselves: enough of them, unlike one another, clear of the border.
TEST(Mutants, ScenesAreDistinctAndClearOfTheBorder) {
  std::set<std::string> pictures;
  EXPECT_GE(named_scenes().size(), 12u);
  for (const NamedScene& one : named_scenes()) {
    const Rendering exact = rasterize(one.scene, {});
    EXPECT_TRUE(pictures.emplace(exact.pixels.begin(), exact.pixels.end()).second) << one.name;
    for (const Fragment& f : exact.fragments) {
      EXPECT_TRUE(std::min(f.x, f.y) >= 2 && std::max(f.x, f.y) <= 13) << one.name;
    }
  }
}

}  // namespace
}  // namespace edgecase
