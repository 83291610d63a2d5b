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
#include "diff/coverage/cause.h"
#include "diff/judge.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "rules/choices.h"
#include "tests/diff/coverage/mutants.h"
#include "tests/diff/named_scenes.h"
#include "tests/support/judging.h"

namespace edgecase {

std::set<std::string> Mutant::causes_in(const std::string& scene) const {
  const auto other = cause_in.find(scene);
  const std::string& all = other == cause_in.end() ? cause : other->second;
  std::set<std::string> result;
  for (std::size_t at = 0; at <= all.size();) {
    const std::size_t end = std::min(all.find(" | ", at), all.size());
    result.insert(all.substr(at, end - at));
    at = end + 3;
  }
  return result;
}

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
      results[one.name] = compare(one.scene, {}, exact, exact, {kReportedBits});
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

std::string fingerprint_of_exact(const std::string& name) {
  const Scene& scene = scene_named(name);
  return judged(scene, rasterize(scene, {})).fingerprint;
}

// The first few disagreements and all aggregates.
std::string describe(const Result& result) {
  std::string text = std::string("verdict ") + name_of(result.verdict) + "\n";
  for (std::size_t i = 0; i < std::min<std::size_t>(3, result.disagreements.size()); ++i) {
    const Disagreement& d = result.disagreements[i];
    text += std::string(name_of(d.kind)) + " " + name_of(d.rule) +
            (is_legal(d) ? " legal" : " illegal") + " cause '" + text_of(d.cause) +
            "': " + d.explanation + "\n";
  }
  for (const ValueAggregate& v : result.values)
    text += v.attribute + " " + name_of(v.rule) + " differs at " +
            std::to_string(v.differing.size()) + "\n";
  return text;
}

// Whether the cause that was chosen must be the mutant's, or only one that draws the same: where
// all other scenes are drawn right, they speak against every alternative, and the one that they
// speak against least is chosen.
enum class CauseMustBe { the_mutants, one_that_reproduces };

bool reproduces(const Result& result, const Disagreement& d, const std::string& cause) {
  for (const Result::Evidence& evidence : result.evidence)
    if (evidence.primitive == d.primitive)
      return !cause.empty() &&
             std::ranges::find(evidence.causes, cause_named(cause)) != evidence.causes.end();
  return d.cause == cause;
}

bool is_about_pixels(RuleId rule) {
  return rule == "framebuffer.unorm8" || rule == "framebuffer.order";
}

// Does the mutant break its rule or, where it is allowed, come under it?
bool comes_under_its_rule(const Mutant& mutant, const Scene& scene, const Result& result) {
  const auto primitives = primitives_of(scene);
  const auto own_rule = [&](int primitive) -> std::string {
    if (mutant.rule != kCoverage) return mutant.rule;
    if (primitive < 0) return "";
    return name_of(coverage_rule_of(primitives[static_cast<std::size_t>(primitive)].kind));
  };
  const bool illegal = mutant.verdict >= Verdict::contested;
  return std::any_of(result.disagreements.begin(), result.disagreements.end(),
                     [&](const Disagreement& d) {
                       return d.rule == own_rule(d.primitive) && is_legal(d) != illegal;
                     }) ||
         (!illegal && std::any_of(result.values.begin(), result.values.end(),
                                  [&](const ValueAggregate& v) { return v.rule == mutant.rule; }));
}

void expect_as_the_mutant_says(const Mutant& mutant, const std::string& scene, const Result& result,
                               CauseMustBe must_be) {
  EXPECT_STREQ(name_of(result.verdict), name_of(mutant.verdict)) << describe(result);
  EXPECT_NE(result.verdict, Verdict::agree);
  EXPECT_NE(result.fingerprint, fingerprint_of_exact(scene));
  EXPECT_FALSE(mutant.rule.empty());
  EXPECT_TRUE(comes_under_its_rule(mutant, scene_named(scene), result)) << describe(result);
  const std::set<std::string> causes = mutant.causes_in(scene);
  std::set<std::string> given;
  for (const Disagreement& d : result.disagreements) {
    EXPECT_FALSE(d.explanation.empty());
    EXPECT_NE(find_rule(name_of(d.rule)), nullptr) << name_of(d.rule);
    EXPECT_NE(find_ruling(d.ruling), nullptr) << name_of(d.rule) << " " << d.ruling;
    if (is_about_pixels(d.rule)) {
      EXPECT_EQ(d.cause, "");
      continue;
    }
    given.insert(text_of(d.cause));
    if (must_be == CauseMustBe::the_mutants || d.cause.empty()) continue;
    EXPECT_TRUE(reproduces(result, d, text_of(d.cause))) << describe(result);
    EXPECT_TRUE(std::any_of(causes.begin(), causes.end(), [&](const std::string& cause) {
      return reproduces(result, d, cause);
    })) << describe(result);
  }
  const bool exactly = must_be == CauseMustBe::the_mutants && !given.empty();
  EXPECT_TRUE(!exactly || given == causes) << describe(result);
  EXPECT_TRUE(!given.contains("") || causes.contains("")) << describe(result);
}

// The pixels of one primitive.
std::vector<PixelPosition> pixels_of(const Rendering& rendering, int primitive) {
  std::vector<PixelPosition> pixels;
  for (const Fragment& f : rendering.fragments)
    if (f.primitive == primitive) pixels.push_back({f.x, f.y});
  return pixels;
}

Policy policy_of_cause(const std::string& cause) {
  Policy policy;
  for (const std::string& part : parts_of(cause))
    policy.rules[part.substr(0, part.find('='))] = part.substr(part.find('=') + 1);
  return policy;
}

// By the rasterizer alone: the cause draws the primitive as it was drawn or, where there is none,
// no single alternative does.
void expect_true_cause(const Scene& scene, const Rendering& wrong, const Disagreement& d) {
  if (d.kind == DisagreementKind::value || d.cause == Cause(kInteriorGap)) return;
  const auto drawn = pixels_of(wrong, d.primitive);
  const auto drawn_by = [&](const std::string& cause) {
    return pixels_of(rasterize(scene, policy_of_cause(cause)), d.primitive);
  };
  if (!d.cause.empty()) {
    EXPECT_EQ(drawn_by(text_of(d.cause)), drawn) << text_of(d.cause);
    return;
  }
  for (const std::string& alternative : alternative_names())
    EXPECT_NE(drawn_by(alternative), drawn) << alternative << " would have drawn this";
}

void expect_true_causes(const Scene& scene, const Rendering& wrong, const Result& result) {
  std::set<int> seen;
  for (const Disagreement& d : result.disagreements)
    if (seen.insert(d.primitive).second) expect_true_cause(scene, wrong, d);
}

int check(const std::vector<Mutant>& mutants) {
  int applied = 0;
  for (const Mutant& mutant : mutants)
    for (const std::string& name : scenes_of(mutant)) {
      SCOPED_TRACE(mutant.name + " / " + name);
      const Scene& scene = scene_named(name);
      const Rendering exact = rasterize(scene, {});
      const Rendering wrong = mutant.mutate(scene, exact);
      Result result = compare(scene, {}, exact, wrong, {kReportedBits});
      ++applied;
      EXPECT_TRUE(!result.disagreements.empty() || !result.values.empty());
      expect_as_the_mutant_says(mutant, name, judged_in_a_run(name, result),
                                CauseMustBe::one_that_reproduces);
      Result* const alone[] = {&result};
      judge(alone, Latitude::opengl);
      expect_as_the_mutant_says(mutant, name, result, CauseMustBe::the_mutants);
      expect_true_causes(scene, wrong, result);
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
TEST(Mutants, OfJointsOfLines) {
  EXPECT_GT(check(joint_mutants()), 20);
}
TEST(Mutants, OfTrianglesAndPoints) {
  EXPECT_GT(check(area_mutants()), 20);
}
TEST(Mutants, OfMovedVertices) {
  EXPECT_GT(check(moved_mutants()), 50);
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

TEST(Mutants, AreManyAndNoneStandsTwice) {
  std::set<std::string> names;
  std::set<std::pair<std::string, std::string>> renderings;
  for (const auto& mutants :
       {general_mutants(), line_mutants(), joint_mutants(), area_mutants(), moved_mutants(),
        alternative_mutants(), value_mutants(), pixel_mutants()})
    for (const Mutant& mutant : mutants) {
      names.insert(mutant.name);
      for (const std::string& scene : scenes_of(mutant))
        EXPECT_TRUE(renderings.emplace(mutant.name, scene).second) << mutant.name << " " << scene;
    }
  EXPECT_GE(names.size(), 110u);
  EXPECT_GE(renderings.size(), 700u);
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
