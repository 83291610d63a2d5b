// SPDX-License-Identifier: MIT
//
// Families and mutations: the same for the same seed and index, exact on their way to OpenGL, what
// a case file can say, and of the forms that they promise.
#include "search/families.h"
#include "search/mutation.h"
#include "search/scene_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "casefile/case_writer.h"
#include "casefile/scene/viewport.h"
#include "generate/random_scenes.h"
#include "generate/random_shapes.h"
#include "generate/seam_scenes.h"
#include "model/scene.h"
#include "rules/all_rules.h"
#include "rules/samples/sample_placement.h"
#include "tests/generate/scene_checks.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::uint64_t kSeed = 5;

std::string what_no_file_says(const Scene& scene) {
  CaseWords words;
  words.title = "A scene";
  words.rules = {"fragment.once"};
  const CaseText text = case_text(scene, words);
  return text.diagnostics.empty() ? "" : to_string(text.diagnostics.front());
}

std::vector<std::string> selected(const std::vector<std::string>& patterns) {
  const auto families = select_families(patterns);
  std::vector<std::string> names;
  if (const auto* found = std::get_if<std::vector<const Family*>>(&families))
    for (const Family* family : *found) names.emplace_back(family->name);
  return names;
}

TEST(Families, AreAboutRulesOfTheCatalogue) {
  for (const Family& family : all_families()) {
    EXPECT_FALSE(family.rules.empty()) << family.name;
    for (const RuleId rule : family.rules) EXPECT_NE(rule, RuleId::none);
  }
}

TEST(Families, AreFunctionsOfSeedSurfaceAndIndexThatCaseFilesCanSay) {
  for (const Family& family : all_families())
    for (std::uint64_t index = 0; index < 60; ++index) {
      const Surface surface = index % 2 == 1 && family.has_windows ? Surface::window : Surface::fbo;
      const Scene scene = family.scene(kSeed, surface, index);
      ASSERT_EQ(scene.target.surface, surface) << family.name;
      ASSERT_TRUE(same_scene(scene, family.scene(kSeed, surface, index))) << family.name;
      ASSERT_EQ(what_no_file_says(scene), "") << family.name << " " << index;
      if (family.coverage_only) {
        ASSERT_EQ(scene.target.samples, 1);
        ASSERT_EQ(fault_of(scene, kMostSeamTarget), "") << family.name << " " << index;
      }
    }
}

TEST(Families, OfCoverageHoldTiesInAThird) {
  for (const Family& family : all_families()) {
    // Seams pass beside centres (tests/generate/seam_scenes_test.cpp).
    if (!family.coverage_only || family.scene == seam_scene) continue;
    int ties = 0;
    for (std::uint64_t index = 0; index < 600; ++index)
      if (has_tie(family.scene(kSeed, Surface::fbo, index))) ++ties;
    EXPECT_GE(3 * ties, 600) << family.name;
  }
}

TEST(Families, OfSamplesHaveTwoFourAndEightWithTies) {
  const Family& family = *find_family("samples");
  std::map<int, int> targets;
  int ties = 0;
  for (std::uint64_t index = 0; index < 300; ++index) {
    const Scene scene = family.scene(kSeed, Surface::window, index);
    EXPECT_EQ(scene.target.surface, Surface::fbo);
    ++targets[scene.target.samples];
    if (has_tie(scene, standard_pattern(scene.target.samples))) ++ties;
  }
  EXPECT_EQ(targets, (std::map<int, int>{{2, 100}, {4, 100}, {8, 100}}));
  EXPECT_GE(3 * ties, 300);
}

TEST(Families, OfAttributesHaveEachInterpolationProvokingVertexAndW) {
  const Family& family = *find_family("attributes");
  std::set<Interpolation> interpolations;
  std::set<ProvokingVertex> provoking;
  int perspective = 0;
  for (std::uint64_t index = 0; index < 60; ++index) {
    const Scene scene = family.scene(kSeed, Surface::fbo, index);
    interpolations.insert(scene.draws[0].interpolation);
    provoking.insert(scene.draws[0].provoking_vertex);
    if (has_perspective(primitives_of(scene).front())) ++perspective;
  }
  EXPECT_EQ(interpolations.size(), 3u);
  EXPECT_EQ(provoking.size(), 2u);
  EXPECT_GT(perspective, 10);
}

TEST(Families, AreSelectedByNameRuleAndGlob) {
  EXPECT_EQ(selected({}).size(), all_families().size());
  EXPECT_THAT(selected({"shared-edges", "lines"}), ElementsAre("lines", "shared-edges"));
  EXPECT_THAT(selected({"line.joint"}), ElementsAre("joints", "grid-joints"));
  EXPECT_THAT(selected({"line.*"}),
              ElementsAre("lines", "grid-lines", "grid-lines-2-wide", "joints", "grid-joints",
                          "snapping", "samples", "grid-lines-of-4-samples"));
  EXPECT_THAT(selected({"texture.*", "clip*"}), ElementsAre("lod", "clipping"));
}

TEST(Families, ThatAreUnknownAreRefusedWithTheList) {
  const std::vector<std::string> patterns{"lines", "linse"};
  const auto families = select_families(patterns);
  const auto* message = std::get_if<std::string>(&families);
  ASSERT_NE(message, nullptr);
  EXPECT_THAT(*message, HasSubstr("\"linse\""));
  EXPECT_THAT(*message, HasSubstr("shared-edges"));
  EXPECT_THAT(*message, HasSubstr("line.diamond-exit"));
}

TEST(SceneSources, TakeFamiliesInTurnAndAlternateSurfaces) {
  SceneSource source(1, {find_family("lines"), find_family("samples")},
                     {Surface::fbo, Surface::window}, {});
  std::vector<Batch> first = source.next_round(1'000);
  ASSERT_EQ(first.size(), 2u);
  EXPECT_STREQ(first[0].family->name, "lines");
  EXPECT_EQ(first[0].surface, Surface::fbo);
  EXPECT_EQ(first[0].count, SceneSource::kBatch);
  std::vector<Batch> second = source.next_round(300);
  EXPECT_EQ(second[0].surface, Surface::window);
  EXPECT_EQ(second[0].first, 0u);
  EXPECT_EQ(second[1].surface, Surface::fbo);  // there are no others
  EXPECT_EQ(second[1].first, SceneSource::kBatch);
  EXPECT_EQ(second[0].count + second[1].count, 300u);
  source.retire(*find_family("samples"));
  source.add_to_corpus({"a find", find_family("lines")->scene(1, Surface::fbo, 3)});
  std::vector<Batch> third = source.next_round(1'000);
  ASSERT_EQ(third.size(), 2u);
  EXPECT_EQ(third[0].first, SceneSource::kBatch);
  EXPECT_EQ(third[1].family, nullptr);
  const auto mutant = source.scene(third[1], 0);
  ASSERT_TRUE(mutant);
  EXPECT_EQ(describe(mutant->origin, 1), "mutated from a find, seed 1, index 0");
}

TEST(SceneSources, EndWhereFamiliesDo) {
  Family few = *find_family("lines");
  few.scenes = 300;
  SceneSource source(1, {&few}, {Surface::fbo, Surface::window});
  source.add_to_corpus({"a find", few.scene(1, Surface::fbo, 3)});  // nothing is mutated
  for (const auto& [first, count] : {std::pair{0u, 256u}, {256u, 44u}})
    for (const Surface surface : {Surface::fbo, Surface::window}) {
      const std::vector<Batch> round = source.next_round(1'000);
      ASSERT_EQ(round.size(), 1u);
      EXPECT_EQ(round[0].surface, surface);
      EXPECT_EQ(round[0].first, first);
      EXPECT_EQ(round[0].count, count);
    }
  EXPECT_TRUE(source.next_round(1'000).empty());
}

TEST(Mutations, ChangeScenesIntoOthersThatReachOpenGlExactly) {
  std::set<Primitive> primitives;
  std::map<std::string, int> changed;
  int made = 0;
  for (const Family& family : all_families())
    for (std::uint64_t index = 0; index < 24; ++index) {
      const Scene scene = family.scene(kSeed, Surface::fbo, index % 8);
      RandomSource random(kSeed, 1, index);
      RandomSource again(kSeed, 1, index);
      const auto mutant = mutated(scene, random);
      const auto same = mutated(scene, again);
      ASSERT_EQ(mutant.has_value(), same.has_value());
      if (!mutant) continue;
      ++made;
      ASSERT_TRUE(same_scene(*mutant, *same));
      ASSERT_FALSE(same_scene(*mutant, scene)) << family.name;
      ASSERT_EQ(what_no_file_says(*mutant), "") << family.name;
      const Target& target = mutant->target;
      if (target.width != scene.target.width || target.height != scene.target.height)
        ++changed["target"];
      if (target.samples != scene.target.samples) ++changed["samples"];
      if (primitives_of(*mutant).size() < primitives_of(scene).size()) ++changed["fewer"];
      if (primitives_of(*mutant).size() > primitives_of(scene).size()) ++changed["more"];
      const Draw& before = scene.draws[0];
      const Draw& after = mutant->draws[0];
      if (after.interpolation != before.interpolation) ++changed["interpolation"];
      if (after.provoking_vertex != before.provoking_vertex) ++changed["provoking vertex"];
      if (after.line_width != before.line_width) ++changed["width"];
      for (const Vertex& vertex : after.vertices)
        if (vertex.position.x.raw() % Fixed::kOne == Fixed::kOne / 2 &&
            vertex.position.y.raw() % Fixed::kOne == Fixed::kOne / 2)
          ++changed["centre"];
    }
  EXPECT_GT(made, 200);
  for (const char* what : {"target", "samples", "fewer", "more", "interpolation",
                           "provoking vertex", "width", "centre"})
    EXPECT_GT(changed[what], 0) << what;
}

}  // namespace
}  // namespace edgecase
