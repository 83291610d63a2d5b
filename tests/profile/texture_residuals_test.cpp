// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "profile/evidence/inference.h"
#include "profile/profile.h"
#include "profile/textures/textures.h"
#include "raster/rasterizer.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

RuleChoices choices_of(const Choices& rules) {
  Policy policy;
  policy.rules = rules;
  return resolve(policy, Surface::fbo);
}

Rendering rendering_of(const Scene& scene, const Choices& rules) {
  Policy policy;
  policy.rules = rules;
  return rasterize(scene, policy);
}

Scene ramp_of(RampKind kind, std::uint64_t index = 0) {
  return ramp_scene({1, Surface::fbo, kind, RampPurpose::residuals}, index);
}

std::vector<FragmentLookup> all_of(const Rendering& rendering) {
  return lookups_of(rendering, rendering.fragments.size());
}

const FormulaResidual& formula_of(const LevelResiduals& row, ScaleFactor scale, Log2Method log2) {
  for (const FormulaResidual& formula : row.formulas)
    if (formula.scale_factor == scale && formula.log2 == log2) return formula;
  ADD_FAILURE();
  return row.formulas[0];
}

TEST(ResidualTable, IsExactForTheFormulaThatIsFollowed) {
  const Choices rules{{"texture.scale-factor", "largest-partial"},
                      {"texture.log2", "linear-mantissa"},
                      {"texture.derivatives", "quad-coarse-top-right"}};
  ResidualTable table(choices_of(rules));
  for (const RampKind kind : values_of<RampKind>())
    for (std::uint64_t i = 0; i < 5; ++i) {
      const Scene scene = ramp_of(kind, i);
      table.add(kind, "ramp", scene, all_of(rendering_of(scene, rules)));
    }
  ASSERT_EQ(table.rows().size(), 2 * values_of<RampKind>().size());
  for (const LevelResiduals& row : table.rows()) {
    EXPECT_EQ(row.derivatives, "quad-coarse-top-right");
    EXPECT_EQ(row.formulas.size(),
              values_of<ScaleFactor>().size() * values_of<Log2Method>().size());
    EXPECT_EQ(row.found().scale_factor, ScaleFactor::largest_partial);
    EXPECT_GT(row.found().fragments, 1000u);
    EXPECT_LT(row.found().largest, 1e-9) << row.ramp;
    const double straight =
        formula_of(row, ScaleFactor::largest_partial, Log2Method::exact).largest;
    EXPECT_GT(straight, 0.08) << row.ramp;
    EXPECT_LT(straight, 0.0862) << row.ramp;
  }
}

// Levels off by known amounts: the largest, the mean, where it is.
TEST(ResidualTable, NamesTheFragmentThatIsFarthestOff) {
  const Scene scene = ramp_of(RampKind::rotated);
  Rendering rendering = rendering_of(scene, {});
  const std::size_t at = 300;
  const auto& fragment = rendering.fragments[at];
  rendering.details[static_cast<std::size_t>(fragment.detail)].level_of_detail.value()[1] += 0.25;
  ResidualTable table(choices_of({}));
  table.add(RampKind::rotated, "ramp rotated/00000", scene, all_of(rendering));
  const LevelResiduals& query = table.rows()[0];
  ASSERT_EQ(query.source, LevelSource::query);
  EXPECT_EQ(query.found().fragments, 1024u);
  EXPECT_NEAR(query.found().largest, 0.25, 1e-9);
  EXPECT_NEAR(query.found().mean(), 0.25 / 1024, 1e-9);
  ASSERT_TRUE(query.found().worst);
  EXPECT_EQ(query.found().worst->id, "ramp rotated/00000");
  EXPECT_EQ(query.found().worst->pixel, (PixelPosition{fragment.x, fragment.y}));
  EXPECT_EQ(query.found().worst->primitive, fragment.primitive);
  EXPECT_NEAR(query.found().worst->reported - query.found().worst->formula, 0.25, 1e-9);
  const LevelResiduals& color = table.rows()[1];
  ASSERT_EQ(color.source, LevelSource::color);
  EXPECT_LT(color.found().largest, 1e-9);
}

// Looked-up levels beyond both ends say nothing; wrong ones among them do.
TEST(ResidualTable, LeavesOutLevelsThatAreBothTheSameEnd) {
  const Scene scene = ramp_of(RampKind::magnification);
  Rendering rendering = rendering_of(scene, {});
  std::size_t ends = 0;
  for (const Fragment& fragment : rendering.fragments)
    if (fragment.color[0] == 0 || fragment.color[0] == 6) ++ends;
  ASSERT_GT(ends, 100u);
  ResidualTable table(choices_of({}));
  table.add(RampKind::magnification, "ramp", scene, all_of(rendering));
  EXPECT_EQ(table.rows()[1].found().fragments, 1024 - ends);
  for (Fragment& fragment : rendering.fragments)
    if (fragment.color[0] == 0) fragment.color[0] = 1;
  ResidualTable wrong(choices_of({}));
  wrong.add(RampKind::magnification, "ramp", scene, all_of(rendering));
  EXPECT_GT(wrong.rows()[1].found().fragments, 1024 - ends);
  EXPECT_NEAR(wrong.rows()[1].found().largest, 1, 1e-9);
}

TEST(ResidualTable, WhatIsNoNumberIsFartherOffThanAnything) {
  const Scene scene = ramp_of(RampKind::diagonal);
  Rendering rendering = rendering_of(scene, {});
  rendering.fragments[5].color[0] = std::numeric_limits<double>::quiet_NaN();
  ResidualTable table(choices_of({}));
  table.add(RampKind::diagonal, "ramp", scene, all_of(rendering));
  EXPECT_EQ(table.rows()[1].found().largest, HUGE_VAL);
  EXPECT_THAT(level_residuals_text(table.rows()), HasSubstr("BEYOND"));
  const auto json = nlohmann::json::parse(level_residuals_json(table.rows()).dump());
  EXPECT_FALSE(json[1]["within"]);
  EXPECT_TRUE(json[1]["found"]["largest"].is_null());
}

TEST(ResidualText, ShowsTheFormulaFoundAndAllOthers) {
  const Scene scene = ramp_of(RampKind::rotated);
  ResidualTable table(choices_of({{"texture.log2", "mantissa-8"}}));
  table.add(RampKind::rotated, "ramp rotated/00000", scene, all_of(rendering_of(scene, {})));
  SurfaceProfile surface;
  surface.findings.levels = table.rows();
  Profile profile;
  profile.surfaces = {surface};
  const std::string text = profile_text(profile, 1);
  EXPECT_THAT(text, HasSubstr("levels of detail against lengths + mantissa-8, derivatives "
                              "quad-fine: at most 0.007812 levels of error"));
  EXPECT_THAT(text, HasSubstr("  rotated, textureQueryLod                1024"));
  EXPECT_THAT(text, HasSubstr("  rotated, looked up "));
  EXPECT_THAT(text, HasSubstr("; ramp rotated/00000 128 triangles"));
  EXPECT_THAT(text, HasSubstr("lengths + mantissa-8 (found)"));
  EXPECT_THAT(text, HasSubstr("y-only + linear-mantissa-of-fourth-power"));
  EXPECT_THAT(text, Not(HasSubstr("BEYOND")));
  EXPECT_EQ(level_residuals_text({}), "");
}

TEST(ResidualJson, HasEveryFormulaAndTheWorstScene) {
  const Scene scene = ramp_of(RampKind::perspective);
  ResidualTable table(choices_of({{"texture.log2", "linear-mantissa"}}));
  table.add(RampKind::perspective, "ramp perspective/00000", scene,
            all_of(rendering_of(scene, {})));
  SurfaceProfile surface;
  surface.findings.levels = table.rows();
  Profile profile;
  profile.surfaces = {surface};
  const auto json =
      nlohmann::json::parse(profile_json(profile, "tool"))["surfaces"][0]["levels_of_detail"];
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0]["ramp"], "perspective");
  EXPECT_EQ(json[0]["level"], "query");
  EXPECT_EQ(json[1]["level"], "color");
  EXPECT_EQ(json[0]["derivatives"], "quad-fine");
  EXPECT_EQ(json[0]["most"], kMostResidual);
  // The logarithm is not the one that is followed.
  EXPECT_FALSE(json[0]["within"]);
  EXPECT_EQ(json[0]["formulas"].size(), 40u);
  EXPECT_EQ(json[0]["found"]["log2"], "linear-mantissa");
  EXPECT_EQ(json[0]["found"]["fragments"], 1024);
  EXPECT_GT(json[0]["found"]["largest"], 0.05);
  EXPECT_EQ(json[0]["found"]["worst"]["id"], "ramp perspective/00000");
  EXPECT_TRUE(json[0]["found"]["worst"].contains("case"));
  EXPECT_FALSE(json[0]["formulas"][0].contains("worst"));
}

TEST(Tally, CountsWhatTellsAlternativesApart) {
  Tally tally({"a", "b", "c"}, 0);
  tally.add({true, true, true});
  tally.add({false, true, true});
  tally.add({false, true, false});
  tally.add({false, false, false});
  const Trait trait = tally.trait(TraitId("question"));
  EXPECT_EQ(trait.alternative, "b");
  EXPECT_EQ(trait.rate.agreeing, 2u);
  EXPECT_EQ(trait.rate.of, 2u);
  EXPECT_EQ(trait.runner_up, "c");
  EXPECT_EQ(trait.runner_up_rate.agreeing, 1u);
  EXPECT_EQ(trait.remark, "nothing catalogued yields 1 of 4");
  EXPECT_EQ(tally.trait(TraitId("question"), Tally::None::counted).rate.of, 3u);
}

TEST(Tally, PrefersTheStandardWhereOthersDoAsWell) {
  Tally tally({"a", "b", "c"}, 1);
  EXPECT_EQ(tally.trait(TraitId("question")).alternative, "b");
  EXPECT_EQ(tally.trait(TraitId("question")).remark,
            "no reported value distinguishes the alternatives");
  tally.add({true, true, false});
  EXPECT_EQ(tally.trait(TraitId("question")).alternative, "b");
  EXPECT_EQ(tally.trait(TraitId("question")).runner_up, "a");
  EXPECT_TRUE(tally.trait(TraitId("question")).is_undecided());
  tally.add({true, false, false});
  EXPECT_EQ(tally.trait(TraitId("question")).alternative, "a");
}

TEST(FragmentLookups, AreSpreadOverTheTarget) {
  const Scene scene = ramp_of(RampKind::rotated);
  const auto lookups = lookups_of(rendering_of(scene, {}), 96);
  ASSERT_EQ(lookups.size(), 96u);
  std::array<int, 4> quad_pixels{};
  for (const FragmentLookup& lookup : lookups)
    ++quad_pixels[static_cast<std::size_t>(lookup.pixel.x % 2 + 2 * (lookup.pixel.y % 2))];
  for (const int count : quad_pixels) EXPECT_GT(count, 10);
}

}  // namespace
}  // namespace edgecase
