// SPDX-License-Identifier: MIT
//
// Every mutant of values on each of its scenes, judged by itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <set>

#include "diff/compare.h"
#include "diff/judge.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "tests/diff/values/value_mutants.h"
#include "tests/support/judging.h"

namespace edgecase {
namespace {

std::set<std::string> disagreements_of(const Result& result) {
  std::set<std::string> found;
  for (const Disagreement& d : result.disagreements)
    found.insert(d.cause.empty() ? std::string(name_of(d.rule))
                                 : std::string(name_of(d.rule)) + ": " + text_of(d.cause));
  return found;
}

std::set<std::string> aggregates_of(const Result& result) {
  std::set<std::string> found;
  for (const ValueAggregate& values : result.values) found.insert(values.attribute);
  return found;
}

// The first disagreement of each kind.
std::string describe(const Result& result) {
  std::string text;
  std::set<std::string> seen;
  for (const Disagreement& d : result.disagreements)
    if (seen.insert(name_of(d.rule) + text_of(d.cause)).second)
      text += std::string(name_of(d.rule)) + (is_legal(d) ? " legal '" : " illegal '") +
              text_of(d.cause) + "': " + d.explanation + "\n";
  for (const ValueAggregate& v : result.values)
    text += v.attribute + " differs at " + std::to_string(v.differing.size()) + "\n";
  return text;
}

void expect_reported(const Result& result) {
  for (const Disagreement& d : result.disagreements) {
    EXPECT_FALSE(d.explanation.empty());
    EXPECT_EQ(d.kind, DisagreementKind::value);
    EXPECT_EQ(d.exact.size(), d.rendered.size());
    EXPECT_FALSE(d.exact.empty());
    EXPECT_NE(find_rule(name_of(d.rule)), nullptr) << name_of(d.rule);
    EXPECT_NE(find_ruling(d.ruling), nullptr) << name_of(d.rule) << " " << d.ruling;
  }
}

void expect_killed(const ValueMutant& mutant, const Scene& scene) {
  const Rendering exact = rasterize(scene, {});
  const Rendering wrong = mutant.mutate(scene, exact);
  Result result = judged(scene, wrong);
  EXPECT_STREQ(name_of(result.verdict), name_of(mutant.verdict)) << describe(result);
  EXPECT_NE(result.verdict, Verdict::agree);
  EXPECT_NE(result.fingerprint, judged(scene, exact).fingerprint);
  EXPECT_EQ(disagreements_of(result), mutant.disagreements) << describe(result);
  if (mutant.verdict < Verdict::contested) {
    EXPECT_EQ(aggregates_of(result), mutant.aggregates) << describe(result);
  }
  expect_reported(result);
  Result* const alone[] = {&result};
  judge(alone, Latitude::none);
  EXPECT_EQ(result.verdict, Verdict::violation) << "without latitude every difference is one";
}

int check(const std::vector<ValueMutant>& mutants) {
  int applied = 0;
  for (const ValueMutant& mutant : mutants)
    for (const std::string& name : mutant.scenes) {
      SCOPED_TRACE(mutant.name + " / " + name);
      expect_killed(mutant, value_scene(name));
      ++applied;
    }
  std::printf("%zu mutants, %d wrong renderings\n", mutants.size(), applied);
  return applied;
}

TEST(ValueMutants, OfAttributes) {
  EXPECT_GT(check(attribute_mutants()), 200);
}
TEST(ValueMutants, OfCoordinates) {
  EXPECT_GT(check(coordinate_mutants()), 50);
}
TEST(ValueMutants, OfDerivatives) {
  EXPECT_GT(check(derivative_mutants()), 50);
}
TEST(ValueMutants, OfDepthBuffers) {
  EXPECT_GT(check(depth_buffer_mutants()), 40);
}

// Ruling 16: what vertices on a grid of 8 bits account for is permitted, however it came about.
TEST(ValueMutants, AWrongRowThatMovedVerticesAccountForIsPermitted) {
  Scene gentle = value_scene("small linear triangle");
  gentle.draws[0].vertices[1].w = 1.03125f;
  gentle.draws[0].vertices[2].w = 1.0625f;
  RuleChoices choices;
  choices.values.derivatives[form_of(Derivative::x_fine)] = DerivativeMethod::other_row;
  const Rendering exact = rasterize(gentle, {});
  const Result result = judged(gentle, shaded_under(gentle, exact, choices));
  EXPECT_STREQ(name_of(result.verdict), "permitted") << describe(result);
  EXPECT_GT(result.values.size(), 0u);
}

TEST(ValueMutants, NoneStandsTwiceAndTheScenesAgreeUnspoilt) {
  std::set<std::string> names;
  for (const auto& mutants :
       {attribute_mutants(), coordinate_mutants(), derivative_mutants(), depth_buffer_mutants()})
    for (const ValueMutant& mutant : mutants)
      EXPECT_TRUE(names.insert(mutant.name).second) << mutant.name;
  EXPECT_GE(names.size(), 90u);
  for (const ValueScene& one : value_scenes()) {
    const Rendering exact = rasterize(one.scene, {});
    EXPECT_FALSE(exact.fragments.empty()) << one.name;
    EXPECT_EQ(judged(one.scene, exact).verdict, Verdict::agree) << one.name;
  }
}

}  // namespace
}  // namespace edgecase
