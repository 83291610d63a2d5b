// SPDX-License-Identifier: MIT
//
// A profile finds what was planted: exact under a policy is a renderer that follows it. What it
// says of a rule is never false, and what nothing in the catalogue draws is not known.
#include "profile/profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <random>
#include <utility>

#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "tests/support/altered_renderer.h"
#include "tests/support/core_suite.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

Profile profile_of(const CaseStore& cases, const Policy& policy, const Alter& alter = {},
                   int jobs = 1) {
  return measure(cases, [&] { return std::make_unique<AlteredRenderer>(policy, alter); },
                 {"planted", jobs, {}, nullptr});
}

// Samples are reported where they usually lie, wherever they are.
void as_reported(const Task& task, Rendering& rendering) {
  if (!rendering.sample_positions.empty())
    rendering.sample_positions = rasterize(*task.scene, {}).sample_positions;
}

// A case names a rule that it asks about.
CaseStore cases_naming(const std::vector<Case>& all, const std::string& rule, std::size_t most) {
  CaseStore cases;
  for (const Case& one : all)
    if (std::ranges::find(one.rules, rule) != one.rules.end() && cases.size() < most)
      cases.push_back(one);
  return cases;
}

// False where something else than the planted alternative is said to remain.
bool is_true(const RuleAnswers& answers, const std::string& planted) {
  if (remaining_of(answers) == kNoneKnown) return true;
  const std::size_t index = alternative_id(answers.rule, planted).index;
  return answers.against[index] == *std::ranges::min_element(answers.against);
}

class Profiles : public testing::Test {
 protected:
  static const std::vector<Case>& core() {
    static const std::vector<Case> cases = core_suite().cases.all();
    return cases;
  }
};

// Every alternative of every rule, by the cases that name it.
TEST_F(Profiles, FindEachAlternative) {
  constexpr std::size_t kMostCases = 6;
  Dealer dealer;
  std::size_t planted = 0, known = 0;
  for (const Rule& rule : all_rules()) {
    const CaseStore cases = cases_naming(core(), name_of(rule.id), kMostCases);
    if (cases.empty()) continue;
    for (const Alternative& alternative : rule.alternatives) {
      if (!dealer.deal()) continue;
      Policy policy;
      policy.rules[name_of(rule.id)] = alternative.name;
      const Profile profile = profile_of(cases, policy, as_reported);
      ++planted;
      for (const SurfaceProfile& surface : profile.surfaces)
        for (const RuleAnswers& answers : surface.rules)
          if (answers.rule == rule.id) {
            EXPECT_TRUE(is_true(answers, alternative.name))
                << name_of(rule.id) << "=" << alternative.name << " is " << remaining_of(answers);
            if (remaining_of(answers) != kNoneKnown) ++known;
          }
    }
  }
  EXPECT_GE(10 * known, 9 * planted);
}

// Whether two policies draw the same fragments in nine of ten of the cases that name a rule: rows
// counted from above, and other ties, come to the same.
bool draw_alike(const CaseStore& cases, const Policy& one, const Policy& other) {
  std::size_t alike = 0;
  const auto drawn = [](const Scene& scene, const Policy& policy) {
    std::vector<std::array<int, 3>> fragments;
    for (const Fragment& fragment : rasterize(scene, policy).fragments)
      fragments.push_back({fragment.primitive, fragment.x, fragment.y});
    return fragments;
  };
  for (const Case& each : cases)
    if (drawn(each.scene, one) == drawn(each.scene, other)) ++alike;
  return 10 * alike >= 9 * cases.size();
}

// A fourth of all rules at once, at random.
TEST_F(Profiles, OfMixturesSayNothingFalse) {
  Dealer dealer;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    if (!dealer.deal()) continue;
    std::mt19937 random(seed);
    Policy policy;
    for (const Rule& rule : all_rules())
      if (!rule.alternatives.empty() && random() % 4 == 0)
        policy.rules[name_of(rule.id)] =
            rule.alternatives[random() % rule.alternatives.size()].name;
    const Profile profile = profile_of(core(), policy, as_reported);
    const SurfaceProfile& surface = profile.surfaces.front();
    EXPECT_GE(10 * surface.as_told, 6 * surface.drawn) << "seed " << seed;
    for (const RuleAnswers& answers : surface.rules) {
      const auto chosen = policy.rules.find(name_of(answers.rule));
      if (chosen == policy.rules.end() || is_true(answers, chosen->second)) continue;
      EXPECT_TRUE(
          draw_alike(cases_naming(core(), chosen->first, core().size()), policy, profile.policy))
          << "seed " << seed << ": " << chosen->first << "=" << chosen->second << " is "
          << remaining_of(answers);
    }
  }
}

TEST_F(Profiles, SayOnlyWhatWasAsked) {
  const CaseStore cases = cases_naming(core(), "triangle.fill-rule", 4);
  const Profile profile = profile_of(cases, {});
  for (const SurfaceProfile& surface : profile.surfaces) {
    EXPECT_EQ(surface.as_told, surface.drawn);
    for (const RuleAnswers& answers : surface.rules) {
      EXPECT_LE(answers.asked, surface.cases);
      EXPECT_NE(answers.rule, RuleId::depth_test) << "no case of these has a depth test";
    }
  }
  EXPECT_FALSE(profile.policy.rules.contains("depth.test"));
}

// What a profile once said, and was not so.
TEST_F(Profiles, SayWhatIsKnownFromNineInTenOnAndWhoseBitsTheyAre) {
  RuleAnswers answers{RuleId::clip_volume, 1000, {}};
  answers.against.assign(rule_of(RuleId::clip_volume).alternatives.size(), 1000);
  answers.against[0] = 6;  // 99.4 %
  RuleAnswers rare{RuleId::triangle_fill_rule, 1000, {}};
  rare.against.assign(rule_of(RuleId::triangle_fill_rule).alternatives.size(), 1000);
  rare.against[0] = 845;  // 15.5 %
  SurfaceProfile surface{Surface::fbo, 2000, 2000, 1000, "", {answers, rare}, {}};
  Profile profile{{"one", "", "", "", 4, {}}, 1, {surface}, {}};
  const std::string tables = profile_tables(profile);
  EXPECT_NE(tables.find(rule_of(RuleId::clip_volume).alternatives[0].name + " (994 of 1000)"),
            std::string::npos);
  EXPECT_NE(tables.find("none known (155 of 1000 for "), std::string::npos);
  const std::string summary = profile_summary(profile);
  EXPECT_NE(summary.find("2 rules were asked"), std::string::npos);
  EXPECT_NE(summary.find("no alternative known: triangle.fill-rule (155 of 1000)"),
            std::string::npos);
  EXPECT_NE(summary.find("triangle.fill-rule none known"), std::string::npos);
  EXPECT_NE(summary.find("4 sub-pixel bits are reported, or assumed as nothing is"),
            std::string::npos);
}

TEST_F(Profiles, KnowNoRuleOfWhatDrawsNothing) {
  const CaseStore cases = cases_naming(core(), "triangle.fill-rule", 40);
  const Profile profile = profile_of(cases, {}, [](const Task&, Rendering& rendering) {
    rendering.fragments.clear();
    std::ranges::fill(rendering.pixels, 0);
  });
  for (const SurfaceProfile& surface : profile.surfaces) EXPECT_LT(surface.as_told, surface.drawn);
  EXPECT_FALSE(profile.policy.rules.contains("triangle.fill-rule"));
}

TEST_F(Profiles, AreTheSameOnAnyNumberOfThreads) {
  Policy policy;
  policy.rules = {{"triangle.fill-rule", "right-top"}, {"texture.log2", "mantissa-8"}};
  const CaseStore cases(std::vector<Case>(core().begin(), core().begin() + 60));
  EXPECT_EQ(profile_json(profile_of(cases, policy, {}, 1), "test"),
            profile_json(profile_of(cases, policy, {}, 3), "test"));
}

TEST_F(Profiles, TellASurfaceByItself) {
  Policy policy;
  policy.rules["triangle.fill-rule"] = "left-top";
  policy.surfaces[Surface::window] = {{"triangle.fill-rule", "right-bottom"}};
  Selection ties;
  ties.paths = {std::filesystem::path(EDGECASE_ROOT) / "cases/triangles/ties"};
  CaseStore cases;
  for (Case one : load_suite(ties).cases) {
    one.scene.target.surface = Surface::fbo;
    cases.push_back(one);
    one.scene.target.surface = Surface::window;
    cases.push_back(one);
  }
  const Profile profile = profile_of(cases, policy);
  EXPECT_EQ(profile.policy.rules.at("triangle.fill-rule"), "left-top");
  ASSERT_TRUE(profile.policy.surfaces.contains(Surface::window));
  EXPECT_EQ(profile.policy.surfaces.at(Surface::window).at("triangle.fill-rule"), "right-bottom");
}

}  // namespace
}  // namespace edgecase
