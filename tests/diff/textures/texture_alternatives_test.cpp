// SPDX-License-Identifier: MIT
//
// Renderers that follow an alternative about textures exactly: each is told by name.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>

#include "diff/coverage/cause.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "tests/diff/textures/texture_judging.h"
#include "tests/support/causes.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

using Causes = std::set<std::string>;

// Every alternative of the rules about textures but OpenGL's own, as "rule=alternative".
std::vector<std::string> all_choices() {
  std::vector<std::string> choices;
  for (const Rule& rule : all_rules()) {
    const std::string id = name_of(rule.id);
    if (!id.starts_with("texture.") && !id.starts_with("mipmap.")) continue;
    for (const Alternative& alternative : rule.alternatives)
      if (alternative.name != rule.standard) choices.push_back(id + "=" + alternative.name);
  }
  return choices;
}

// Those that this share asks.
std::vector<std::string> of_share(const std::vector<std::string>& choices) {
  std::vector<std::string> mine;
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (is_in_share_of_few(i, choices.size())) mine.push_back(choices[i]);
  return mine;
}

// Coarser than rulings 20 and 22 permit, and never than ruling 50 does: contested.
bool is_coarse(const std::string& choice) {
  static const std::set<std::string> coarse = {
      "texture.log2=linear-mantissa-of-square", "texture.log2=linear-mantissa-of-fourth-power",
      "texture.level-weight=floor-4", "texture.level-weight=nearest-4",
      "texture.level-weight=nearest-3"};
  return coarse.contains(choice);
}

bool is_contested(const Disagreement& d) {
  return d.ruling == 50 && d.legality == Legality::contested;
}

// A colour that is looked up in the levels that another rule's fault leads to is told beside it.
bool is_exactly(const Result& result, const std::string& choice) {
  const std::string rule = choice.substr(0, choice.find('='));
  if (is_open_choice(choice) && !is_coarse(choice) && result.verdict != Verdict::convention)
    return false;
  const auto& all = result.disagreements;
  const auto is_no_fault = [](const Disagreement& d) { return is_legal(d) || is_contested(d); };
  if (std::ranges::all_of(all, is_no_fault) != (is_open_choice(choice) || is_coarse(choice)))
    return false;
  for (const Disagreement& d : all)
    if (d.rule != rule || d.cause != choice) return false;
  for (const ValueAggregate& values : result.values)
    if (is_open_choice(choice) && (values.rule != rule || values.cause != choice)) return false;
  return true;
}

// In no scene is a choice that OpenGL leaves open a fault, nor is one that it forbids a convention;
// where one is inside what is permitted by chance, nothing is said against it.
void expect_no_other_fault(const Result& result, const std::string& choice,
                           const std::string& scene) {
  if (is_coarse(choice)) {
    for (const Disagreement& d : result.disagreements)
      EXPECT_TRUE(is_contested(d)) << choice << " / " << scene << "\n" << describe_textures(result);
  } else if (is_open_choice(choice)) {
    EXPECT_NE(result.verdict, Verdict::violation) << choice << " / " << scene << "\n"
                                                  << describe_textures(result);
  } else if (result.verdict == Verdict::violation) {
    for (const Disagreement& d : result.disagreements) {
      EXPECT_FALSE(is_legal(d)) << choice << " / " << scene;
      EXPECT_TRUE(is_contested(d) || d.cause.empty() || !is_open_choice(d.cause))
          << choice << " / " << scene << " " << d.cause;
    }
  }
}

TEST(TextureAlternatives, EachIsNamedAsTheOnlyCauseAndOpenOnesAreFaultsNowhere) {
  int named = 0, differing = 0;
  for (const std::string& choice : of_share(all_choices())) {
    std::string reported;
    bool is_named = false;
    for (const TexturedScene& one : judged_textures()) {
      const Result result = judge_follower(one.scene, {choice});
      if (result.verdict == Verdict::agree) continue;
      ++differing;
      is_named = is_named || is_exactly(result, choice);
      reported += one.name + ": " + describe_textures(result) + "\n";
      expect_no_other_fault(result, choice, one.name);
    }
    EXPECT_TRUE(is_named) << choice << "\n" << reported;
    named += is_named ? 1 : 0;
  }
  std::printf("%d alternatives\n", named);
  EXPECT_GE(named, least_of(40));
  EXPECT_GT(differing, least_of(100));
}

// A largest level of detail of 0 magnifies what a last level of 0 does not.
TEST(TextureAlternatives, LimitsOfLevel0AreToldByTheFilterOfMagnification) {
  const std::string choice = "texture.level-limits=max-level-as-max-lod";
  const Result result = judge_follower(textures_named("level 0 alone"), {choice});
  EXPECT_EQ(result.verdict, Verdict::violation);
  ASSERT_FALSE(result.disagreements.empty());
  for (const Disagreement& d : result.disagreements) EXPECT_EQ(d.cause, choice);
}

// The same numbers rounded to float32, as a GPU tells them, change nothing of it.
TEST(TextureAlternatives, AreNamedInFloat32) {
  const std::pair<const char*, const char*> cases[] = {
      {"texture.log2=linear-mantissa", "floor"},
      {"texture.log2=linear-mantissa-of-square", "floor"},
      {"texture.log2=linear-mantissa-of-fourth-power", "floor"},
      {"texture.scale-factor=x-only", "floor"},
      {"texture.scale-factor=length-of-sum", "floor"},
      {"texture.derivatives=quad-other-row", "floor"},
      {"texture.level-weight=floor-3", "floor"},
      {"texture.level-weight=one-at-ties", "ties between levels"},
      {"texture.wrap=mirrored-as-repeat", "mirrored"},
      {"texture.lod-bias=half-a-level-more", "ties between levels"},
      {"texture.nearest-level=even-at-ties", "ties of levels"},
      {"texture.crossover=by-filters", "crossover"}};
  for (const auto& [choice, name] : cases) {
    const Scene& scene = textures_named(name);
    const Rendering rendered = in_float32(scene, rasterize(scene, policy_from({choice})));
    const Result result = judge_textures(scene, rendered);
    Causes causes = causes_of(result);
    causes.erase("");  // what lies within what the exact way may err, or is permitted by chance
    EXPECT_EQ(causes, Causes{choice}) << name << "\n" << describe_textures(result);
  }
}

// Where nothing changes along x the level is the logarithm of 0, and colours are of the base level.
TEST(TextureAlternatives, ALevelOfDerivativesThatAreZeroIsNamed) {
  Sampler sampler;
  sampler.minify = sampler.magnify = Filter::linear;
  sampler.mipmap = MipFilter::linear;
  Scene scene = flat_scene(3.3, TextureFormat::rgba32f, sampler);
  for (Vertex& vertex : scene.draws[0].vertices) vertex.texture_coordinates[0] = 0.3125f;
  const std::string choice = "texture.scale-factor=x-only";
  Rendering rendered = rasterize(scene, policy_from({choice}));
  for (const FragmentDetail& detail : rendered.details)
    EXPECT_EQ(detail.level_of_detail.value()[1], -std::numeric_limits<double>::infinity());
  const Result result = judge_textures(scene, in_float32(scene, rendered));
  EXPECT_EQ(result.verdict, Verdict::violation);
  EXPECT_EQ(result.disagreements.size(), rendered.fragments.size()) << describe_textures(result);
  for (const Disagreement& d : result.disagreements) {
    EXPECT_EQ(d.rule, "texture.scale-factor");
    EXPECT_EQ(d.cause, choice);
  }
  // Whoever tells that level and takes another is told of the filter, too.
  for (Fragment& fragment : rendered.fragments) fragment.color[0] += 1;
  bool is_reported = false;
  for (const Disagreement& d : judge_textures(scene, in_float32(scene, rendered)).disagreements)
    is_reported = is_reported || (d.rule == "texture.filter" && d.cause.empty());
  EXPECT_TRUE(is_reported);
}

TEST(TextureAlternatives, WhoAnswersExactAgreesWithoutASingleAggregate) {
  for (const TexturedScene& one : judged_textures()) {
    const Rendering exact = rasterize(one.scene, {});
    const Result result = judge_textures(one.scene, exact);
    EXPECT_EQ(result.verdict, Verdict::agree) << one.name << "\n" << describe_textures(result);
    EXPECT_TRUE(result.values.empty() && result.disagreements.empty()) << one.name;
    // Float32 numbers are what is compared.
    const Result rounded = judge_textures(one.scene, in_float32(one.scene, exact));
    EXPECT_EQ(rounded.verdict, Verdict::agree) << one.name << "\n" << describe_textures(rounded);
  }
}

TEST(TextureAlternatives, WhoeverFollowsAPolicyAgreesWithItByItself) {
  for (const std::string& choice : of_share(all_choices())) {
    Policy policy = policy_from({choice});
    policy.latitude = Latitude::none;
    for (const TexturedScene& one : judged_textures()) {
      const Result result = judge_textures(one.scene, rasterize(one.scene, policy), policy);
      EXPECT_EQ(result.verdict, Verdict::agree) << choice << " / " << one.name << "\n"
                                                << describe_textures(result);
    }
  }
}

// OpenGL judges a policy and its followers alike.
TEST(TextureAlternatives, APolicyExcusesNothingThatOpenGlForbids) {
  int judged = 0;
  std::vector<std::string> forbidden = all_choices();
  std::erase_if(forbidden, [](const std::string& choice) { return is_open_choice(choice); });
  for (const std::string& choice : of_share(forbidden)) {
    const Policy policy = policy_from({choice});
    for (const TexturedScene& one : judged_textures()) {
      const Rendering rendered = rasterize(one.scene, policy);
      const bool is_fault = judge_textures(one.scene, rendered).verdict == Verdict::violation;
      const Result own = judge_textures(one.scene, rendered, policy);
      EXPECT_EQ(own.verdict == Verdict::violation, is_fault) << choice << " / " << one.name << "\n"
                                                             << describe_textures(own);
      for (const Disagreement& d : own.disagreements) {
        EXPECT_TRUE(d.policy_agrees);
        EXPECT_EQ(d.cause, choice);
      }
      // One who does as OpenGL says is not at fault for leaving the policy.
      const Result lawful = judge_textures(one.scene, rasterize(one.scene, {}), policy);
      EXPECT_NE(lawful.verdict, Verdict::violation) << choice << " / " << one.name << "\n"
                                                    << describe_textures(lawful);
      judged += is_fault ? 1 : 0;
    }
  }
  EXPECT_GT(judged, least_of(30));
}

}  // namespace
}  // namespace edgecase
