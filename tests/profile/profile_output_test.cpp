// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "casefile/policy_reader.h"
#include "profile/profile_json.h"
#include "profile/profile_text.h"

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

Profile sample() {
  Profile profile;
  profile.renderer = {"osmesa:some", "Vendor", "4.5", "Device", 8, {}};
  profile.seed = 7;
  profile.scenes_per_kind = 3000;
  SurfaceProfile fbo;
  fbo.scenes = 9000;
  fbo.random_scenes = 9000;
  fbo.with_ties = 4000;
  fbo.traits = {{"triangle.snap", "8-half-even", {2999, 3000}, "8-half-up", {2900, 3000}, ""},
                {"line.snap", "none", {3000, 3000}, "12-truncate", {3000, 3000}, ""},
                {"line.joint", "pixels twice or gaps", {1, 3}, "", {}, "2 joints with a gap"}};
  fbo.tables = {
      {"ends", {"inside"}, {"right", "up", "left", "down"}, {{{2, 2}, {0, 2}, {1, 2}, {0, 0}}}}};
  Cluster cluster;
  cluster.rule = "point.ownership";
  cluster.kind = "missing";
  cluster.surface = "fbo";
  cluster.situation = "centre inside";
  cluster.disagreements = cluster.cases = 5;
  cluster.smallest_case = "point/00001";
  fbo.illegal_scenes = 5;
  fbo.clusters = {{cluster, one_point()}};
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
      text, HasSubstr("8-half-even                 99.96 % (2999 of 3000)    8-half-up 96.66 %\n"));
  EXPECT_THAT(text, HasSubstr("12-truncate 100 % (as good)\n"));
  EXPECT_THAT(text, HasSubstr("    2 joints with a gap\n"));
  EXPECT_THAT(text, HasSubstr("    inside                  #.? \n"));
  EXPECT_THAT(text,
              HasSubstr("5 point.ownership missing, centre inside, fbo in 5 scenes, NOT allowed\n"
                        "      smallest: point (1, 2), 4x4, pixel (0, 0)\n"));
  EXPECT_THAT(text, HasSubstr("window: not measured: unsupported: no windows\n"));
}

TEST(ProfileText, SaysHowManyClustersItLeavesOut) {
  const std::string text = profile_text(sample(), 0);
  EXPECT_THAT(text, HasSubstr("and 1 more clusters"));
  EXPECT_THAT(text, Not(HasSubstr("centre inside")));
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
  EXPECT_EQ(cluster["legal"], false);
  EXPECT_EQ(cluster["case"]["draws"][0]["primitive"], "points");
  EXPECT_EQ(json["surfaces"][1]["unavailable"], "unsupported: no windows");
}

}  // namespace
}  // namespace edgecase
