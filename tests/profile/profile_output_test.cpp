// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "casefile/policy_reader.h"
#include "profile/profile.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Scene one_point() {
  Scene scene;
  scene.target.width = scene.target.height = 4;
  scene.viewport = {0, 0, 4, 4};
  Draw draw;
  draw.primitive = Primitive::points;
  draw.vertices = {{{Fixed::from_integer(1), Fixed::from_integer(2)}, {}, {1, 1, 1, 1}}};
  scene.draws = {draw};
  return scene;
}

// Ten numbers, seven of them correct, and a NaN; two are beyond what is permitted.
ValueErrors far_off() {
  ValueErrors row;
  row.attribute = "point smooth";
  row.fragments = 3;
  row.components = 11;
  row.not_numbers = 1;
  row.correct = 7;
  row.ulp_sum = 25;
  row.histogram = {{-1, 1}, {3, 2}};
  row.beyond = 2;
  row.not_asked = 4;
  ValueExample worst;
  worst.id = "point smooth/00003";
  worst.scene = one_point();
  worst.pixel = {1, 2};
  worst.component = 2;
  worst.exact = 0.25;
  worst.rendered = 0.5;
  worst.ulp = 12.5;
  worst.relative = 0.125;
  row.worst_ulp = worst;
  worst.permitted = Interval(0.125, 0.375);
  row.smallest_beyond = worst;
  return row;
}

Profile sample() {
  Profile profile;
  profile.renderer = {"osmesa:some", "Vendor", "4.5", "Device", 8, {}};
  profile.seed = 7;
  profile.scenes_per_kind = 3000;
  SurfaceProfile fbo;
  fbo.findings.drawn.scenes = 9000;
  fbo.findings.random_scenes = 9000;
  fbo.findings.with_ties = 4000;
  fbo.findings.traits = {
      {RuleId::triangle_snap, "8-half-even", {2999, 3000}, "8-half-up", {2900, 3000}},
      {RuleId::line_snap, "none", {3000, 3000}, "12-truncate", {3000, 3000}},
      {RuleId::line_joint, "pixels twice or gaps", {1, 3}, "", {}, "2 joints with a gap"}};
  OwnershipTable ends("ends", {"inside"}, {"right", "up", "left", "down"});
  ends.cells = {{{2, 2}, {0, 2}, {1, 2}, {0, 0}}};
  fbo.findings.tables = {ends};
  Cluster cluster;
  cluster.rule = "point.ownership";
  cluster.kind = "missing";
  cluster.surface = "fbo";
  cluster.situations = {{"centre inside", false, 5, 5}};
  cluster.disagreements = cluster.cases = 5;
  cluster.smallest_case = "point/00001";
  fbo.illegal_scenes = 5;
  fbo.clusters = {{cluster, one_point()}};
  fbo.findings.values = {far_off()};
  SurfaceProfile window;
  window.surface = Surface::window;
  window.unavailable = "unsupported: no windows";
  profile.surfaces = {fbo, window};
  profile.policy.name = "osmesa:some";
  profile.policy.rules = {{"triangle.snap", "8-half-even"}, {"line.snap", "none"}};
  profile.policy.surfaces[Surface::window] = {{"triangle.snap", "none"}};
  return profile;
}

TEST(Percent, RoundsDownSoThatOneOfManyShows) {
  EXPECT_EQ(percent({1'000'000, 1'000'000}), "100 %");
  EXPECT_EQ(percent({999'999, 1'000'000}), "99.99 %");
  EXPECT_EQ(percent({1, 3}), "33.33 %");
  EXPECT_EQ(percent({0, 5}), "0.00 %");
  EXPECT_EQ(percent({0, 0}), "-");
}

TEST(ProfileText, ShowsTraitsTablesAndClusters) {
  const std::string text = profile_text(sample(), 10);
  EXPECT_THAT(
      text,
      HasSubstr("8-half-even                      99.96 % (2999 of 3000)    8-half-up 96.66 %\n"));
  EXPECT_THAT(text, HasSubstr("12-truncate 100 % (as good)\n"));
  EXPECT_THAT(text, HasSubstr("    2 joints with a gap\n"));
  EXPECT_THAT(text, HasSubstr("    inside                  #.? \n"));
  EXPECT_THAT(text, HasSubstr("5 point.ownership missing, fbo in 5 scenes, NOT allowed\n"
                              "      smallest: point (1, 2), 4x4, pixel (0, 0)\n"));
  EXPECT_THAT(text, HasSubstr("window: not measured: unsupported: no windows\n"));
}

TEST(ProfileText, ShowsErrorsOfValues) {
  const std::string text = profile_text(sample(), 10);
  EXPECT_THAT(text, HasSubstr("  point smooth                               3  63.63 %       2^4"
                              "        2.5         12.5            0  2+       1\n"
                              "    errors by 2^n ULP: -1: 1, 3: 2\n"
                              "    largest in ULP: blue at pixel (1, 2) is 0.25, drawn 0.5; point "
                              "smooth/00003 point (1, 2), 4x4\n"
                              "    smallest beyond: blue at pixel (1, 2) is 0.25, drawn 0.5, "
                              "permitted 0.125 to 0.375; point smooth/00003 point (1, 2), 4x4\n"));
  EXPECT_THAT(text, Not(HasSubstr("*: against")));
}

TEST(ValueErrorsText, TellsWhatIsHeldAgainstTheProfileApart) {
  ValueErrors row = far_off();
  row.as_found = true;
  const std::string text = value_errors_text({&row, 1});
  EXPECT_THAT(text, HasSubstr("  point smooth * "));
  EXPECT_THAT(text, HasSubstr("*: against the rules that the renderer is found to follow"));
  EXPECT_EQ(value_errors_text({}), "");
}

TEST(ValueErrors, BoundsAShareOfTheErrors) {
  const ValueErrors row = far_off();  // 0 seven times, below 1 once, 8 to 16 twice
  EXPECT_EQ(row.log2_bound(0.7), std::nullopt);
  EXPECT_EQ(row.log2_bound(0.8), 0);
  EXPECT_EQ(row.log2_bound(0.81), 4);
  EXPECT_EQ(row.mean_ulp(), 2.5);
}

TEST(ProfileText, SaysHowManyClustersItLeavesOut) {
  const std::string text = profile_text(sample(), 0);
  EXPECT_THAT(text, HasSubstr("and 1 more cluster; --json has all"));
  EXPECT_THAT(text, Not(HasSubstr("point.ownership missing")));
}

TEST(ProfileSummary, TellsTheMostOfEachSurfaceInFewLines) {
  EXPECT_EQ(
      profile_summary(sample()),
      "osmesa:some: Device, 4.5\n"
      "9,000 scenes drawn, seed 7; 8 sub-pixel bits are reported\n"
      "fbo: 1 of 3 traits that were asked hold in every scene; for 1 another alternative is as "
      "good\n"
      "  least followed: line.joint pixels twice or gaps (33.33 %), triangle.snap 8-half-even "
      "(99.96 %)\n"
      "  outside the specification: 5 scenes; first point.ownership missing, "
      "fbo, in 5 scenes\n"
      "window: not measured: unsupported: no windows\n"
      "coverage: triangle.snap 8-half-even\n");
  Profile sound = sample();
  sound.surfaces[0].illegal_scenes = 0;
  sound.surfaces[0].findings.traits.resize(2);
  sound.surfaces[0].findings.traits[0].rate = {3000, 3000};
  sound.surfaces[1] = sound.surfaces[0];
  const std::string text = profile_summary(sound);
  EXPECT_THAT(text, HasSubstr("  least followed: none\n  outside the specification: nothing\n"));
  EXPECT_LE(std::ranges::count(text, '\n'), 9) << "the command adds the tenth line";
}

// Four sentences that were false: of what was never asked, of an alternative beside one that fits
// nearly always, of one that fits rarely, and of bits that nobody reported.
TEST(ProfileSummary, SaysOnlyWhatWasAskedAndWhatAgreed) {
  Profile profile = sample();
  profile.surfaces.resize(1);
  profile.renderer.subpixel_bits = 4;
  profile.surfaces[0].findings.traits = {
      {RuleId::stencil_test, "as-set", {0, 0}},
      {RuleId::depth_test, "as-set", {0, 0}},
      {RuleId::line_snap, "none", {3000, 3000}},
      {RuleId::clip_volume, "none fits", {17, 3000}, "homogeneous", {2983, 3000}},
      {RuleId::triangle_fill_rule, "open", {465, 3000}, "closed", {400, 3000}}};
  const std::string text = profile_summary(profile);
  EXPECT_THAT(text, HasSubstr("4 sub-pixel bits are reported, or assumed as nothing is\n"
                              "fbo: 1 of 3 traits that were asked hold in every scene; 2 could not "
                              "be asked\n"
                              "  least followed: triangle.fill-rule none known (15.50 %), "
                              "clip.volume homogeneous (99.43 %)\n"));
  EXPECT_THAT(text, HasSubstr("coverage: triangle.fill-rule none known\n"));
  EXPECT_THAT(profile_text(profile, 0),
              HasSubstr("stencil.test                          not asked"));
}

TEST(PolicyText, IsReadBackAsTheSamePolicy) {
  const Profile profile = sample();
  const LoadedPolicy loaded = load_policy_text(policy_text(profile), "profile.json", {});
  ASSERT_TRUE(loaded.value.has_value());
  EXPECT_EQ(loaded.value->name, profile.policy.name);
  EXPECT_EQ(loaded.value->latitude, Latitude::opengl);
  EXPECT_EQ(loaded.value->rules, profile.policy.rules);
  EXPECT_EQ(loaded.value->surfaces, profile.policy.surfaces);
}

TEST(ProfileJson, HoldsEverythingAndTheSmallestSceneAsACase) {
  const auto json = nlohmann::json::parse(profile_json(sample(), "edgecase test"));
  EXPECT_EQ(json["renderer"]["subpixel_bits"], 8);
  EXPECT_EQ(json["policy"]["surfaces"]["window"]["triangle.snap"], "none");
  const auto& fbo = json["surfaces"][0];
  EXPECT_EQ(fbo["traits"][0]["agreement"]["agreeing"], 2999);
  EXPECT_EQ(fbo["traits"][0]["runner_up"], "8-half-up");
  EXPECT_EQ(fbo["tables"][0]["drawn_of"][0][2], (nlohmann::json{1, 2}));
  const auto& cluster = fbo["clusters"][0];
  EXPECT_EQ(cluster["legality"], "illegal");
  EXPECT_EQ(cluster["case"]["draws"][0]["primitive"], "points");
  const auto& value = fbo["values"][0];
  EXPECT_EQ(value["attribute"], "point smooth");
  EXPECT_EQ(value["against"], "opengl");
  EXPECT_EQ(value["log2_ulp"]["3"], 2);
  EXPECT_EQ(value["beyond"], 2);
  EXPECT_EQ(value["beyond_not_asked"], 4);
  EXPECT_EQ(value["smallest_beyond"]["permitted"], (nlohmann::json{0.125, 0.375}));
  EXPECT_EQ(value["smallest_beyond"]["case"]["draws"][0]["primitive"], "points");
  EXPECT_FALSE(value.contains("largest_of_range"));
  EXPECT_EQ(json["surfaces"][1]["unavailable"], "unsupported: no windows");
}

TEST(ProfileJson, IsTextWhateverTheRendererIsCalled) {
  Profile profile = sample();
  profile.renderer.name = profile.policy.name = "exec:\xff";
  const auto json = nlohmann::json::parse(profile_json(profile, "edgecase test"));
  EXPECT_EQ(json["renderer"]["name"], "exec:\uFFFD");
  EXPECT_EQ(nlohmann::json::parse(policy_text(profile))["name"], "exec:\uFFFD");
}

}  // namespace
}  // namespace edgecase
