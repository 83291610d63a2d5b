// SPDX-License-Identifier: MIT
//
// Renderers that follow several alternatives at once, with and without a profile that says so.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "diff/coverage/cause.h"
#include "raster/rasterizer.h"
#include "tests/diff/textures/texture_judging.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

using Causes = std::set<std::string>;

// Of what is told, without what lies in the reach of the policy's own way.
Causes reported_causes(const Result& result) {
  Causes causes = causes_of(result);
  causes.erase("");
  return causes;
}

struct Pair {
  const char* scene;
  std::vector<std::string> choices;  // in the catalogue's order
};

std::string joined(const std::vector<std::string>& choices) {
  std::string cause;
  for (const std::string& choice : choices) cause += (cause.empty() ? "" : " + ") + choice;
  return cause;
}

TEST(TextureCombinations, TwoAreNamedTogether) {
  const Pair pairs[] = {
      {"rotated",
       {"texture.scale-factor=sum-of-partials", "texture.log2=linear-mantissa-of-square"}},
      {"narrow", {"texture.scale-factor=x-only", "texture.log2=linear-mantissa-of-square"}},
      {"narrow", {"texture.scale-factor=x-only", "texture.lod-bias=half-a-level-more"}},
      {"steep", {"texture.log2=linear-mantissa", "texture.derivatives=quad-coarse-top-right"}},
      {"mirrored linear", {"texture.texel-grid=floor-8", "texture.wrap=mirrored-as-repeat"}},
  };
  for (const Pair& pair : pairs) {
    const Result result = judge_follower(textures_named(pair.scene), pair.choices);
    const std::string whole = joined(pair.choices);
    Causes allowed{whole};
    for (const std::string& choice : pair.choices) allowed.insert(choice);
    const Causes causes = reported_causes(result);
    EXPECT_TRUE(causes.contains(whole)) << pair.scene << "\n" << describe_textures(result);
    for (const std::string& cause : causes)
      EXPECT_TRUE(allowed.contains(cause)) << cause << " in " << describe_textures(result);
    EXPECT_EQ(result.verdict == Verdict::violation, !is_open_choice(whole)) << pair.scene;
  }
}

// The logarithm of these is coarser than ruling 20 permits.
void expect_contested_at_most(const Result& result) {
  for (const Disagreement& d : result.disagreements)
    EXPECT_EQ(d.ruling, 50) << describe_textures(result);
}

const std::vector<std::string> kFour = {
    "texture.log2=linear-mantissa-of-square", "texture.derivatives=quad-coarse-bottom-left",
    "texture.level-weight=floor-8", "texture.texel-grid=floor-8"};

// Is every part of the cause one of these?
bool is_made_of(const std::string& cause, const std::vector<std::string>& choices) {
  for (const std::string& part : parts_of(cause))
    if (std::ranges::find(choices, part) == choices.end()) return false;
  return !cause.empty();
}

TEST(TextureCombinations, AProfileNamesFourAndOnlyThoseThatMatter) {
  const Policy profile = policy_from(kFour);
  std::map<std::string, std::size_t> most;
  for (const char* name : {"floor", "rotated", "steep", "ties between levels", "off the grid",
                           "floor of nearest levels", "mirrored"}) {
    const Result result = judge_follower(textures_named(name), kFour, &profile);
    expect_contested_at_most(result);
    for (const std::string& cause : reported_causes(result)) {
      EXPECT_TRUE(is_made_of(cause, kFour)) << name << ": " << cause;
      most[name] = std::max(most[name], parts_of(cause).size());
    }
  }
  EXPECT_GE(most["floor"], 2u);
  EXPECT_EQ(most["off the grid"], 1u);
  EXPECT_EQ(reported_causes(judge_follower(textures_named("off the grid"), kFour, &profile)),
            Causes{"texture.texel-grid=floor-8"});
  EXPECT_EQ(reported_causes(judge_follower(textures_named("mirrored"), {}, &profile)), Causes{});
}

// Where the level of detail is not told, colours alone have to tell all of it.
TEST(TextureCombinations, AProfileNamesThreeAndFourByColoursAlone) {
  const Policy profile = policy_from(kFour);
  Scene scene = textures_named("floor");
  Rendering rendered = rasterize(scene, profile);
  for (FragmentDetail& detail : rendered.details) detail.level_of_detail.reset();
  const Result result = judge_textures(scene, rendered, {}, &profile);
  expect_contested_at_most(result);
  std::size_t most = 0;
  for (const std::string& cause : reported_causes(result)) {
    EXPECT_TRUE(is_made_of(cause, kFour)) << cause;
    most = std::max(most, parts_of(cause).size());
  }
  EXPECT_GE(most, 3u) << describe_textures(result);
  // Without the profile, no set of three is searched for, and what is open stays so.
  EXPECT_EQ(reported_causes(judge_textures(scene, rendered)).count(joined(kFour)), 0u);
}

// A profile that fits this case in nothing explains nothing, and does no harm.
TEST(TextureCombinations, AWrongProfileHidesNothing) {
  const Policy wrong = policy_from({"texture.log2=mantissa-8", "texture.level-weight=nearest-4"});
  const std::pair<const char*, const char*> tried[] = {
      {"texture.scale-factor=x-only", "narrow"},
      {"texture.lod-bias=half-a-level-more", "ties between levels"}};
  for (const auto& [choice, scene] : tried) {
    const Result result = judge_follower(textures_named(scene), {choice}, &wrong);
    EXPECT_EQ(result.verdict, Verdict::violation) << describe_textures(result);
    EXPECT_EQ(reported_causes(result), Causes{choice}) << describe_textures(result);
  }
}

// The profile's own faults are named as faults.
TEST(TextureCombinations, AFaultInTheProfileStaysAFault) {
  const std::vector<std::string> choices = {"texture.scale-factor=x-only",
                                            "texture.log2=linear-mantissa",
                                            "texture.lod-bias=half-a-level-more"};
  const Policy profile = policy_from(choices);
  const Result result = judge_follower(textures_named("narrow"), choices, &profile);
  EXPECT_EQ(result.verdict, Verdict::violation);
  EXPECT_EQ(reported_causes(result), Causes{joined(choices)}) << describe_textures(result);
}

}  // namespace
}  // namespace edgecase
