// SPDX-License-Identifier: MIT
//
// The suite's galleries: does each show what its policy chooses?
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "casefile/policy_reader.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "suite/policy_contrast.h"
#include "suite/selection.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

const fs::path kSuite = fs::path(EDGECASE_ROOT) / "cases";

std::set<std::string> names_in(const char* folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(kSuite / folder))
    names.insert(entry.path().stem().string());
  return names;
}

Policy policy_called(const std::string& name) {
  const LoadedPolicy loaded = load_policy(kSuite / "policies" / (name + ".json"), known_rules());
  for (const Diagnostic& diagnostic : loaded.diagnostics) ADD_FAILURE() << to_string(diagnostic);
  return loaded.value.value_or(Policy{});
}

Gallery gallery_called(const std::string& name) {
  const LoadedGallery loaded = load_gallery(kSuite / "galleries" / (name + ".json"), known_rules());
  for (const Diagnostic& diagnostic : loaded.diagnostics) ADD_FAILURE() << to_string(diagnostic);
  return loaded.value.value_or(Gallery{});
}

Case case_called(const std::string& id) {
  Selection selection;
  selection.paths = {kSuite / (id.substr(0, id.find(':')) + ".json")};
  const Suite suite = load_suite(selection);
  for (const Case& one : suite.cases)
    if (one.id == id) return one;
  ADD_FAILURE() << "no case " << id;
  return {};
}

// The policy of a picture.
Policy policy_of(Policy policy, const GalleryPicture& picture) {
  for (const auto& [rule, alternative] : picture.rules) policy.rules[rule] = alternative;
  return policy;
}

// The rules of a policy that, put back alone, change one of its gallery's pictures.
std::set<std::string> shown_rules(const Gallery& gallery, const Policy& policy) {
  std::set<std::string> shown;
  for (const GalleryPicture& picture : gallery.pictures) {
    const Scene scene = case_called(picture.case_id).scene;
    const Policy own = policy_of(policy, picture);
    const Rendering drawn = rasterize(scene, own);
    for (const ContrastingChoice& choice : contrasting_choices(own, scene.target.surface))
      if (!shown.contains(choice.rule) &&
          !is_same_picture(rasterize(scene, with_standard(own, {choice.rule})), drawn))
        shown.insert(choice.rule);
  }
  return shown;
}

TEST(Galleries, EveryPolicyHasOneAndEveryOneAPolicy) {
  EXPECT_EQ(names_in("galleries"), names_in("policies"));
  for (const std::string& name : names_in("galleries")) {
    EXPECT_EQ(gallery_called(name).policy, name);
    EXPECT_EQ(policy_called(name).name, name);
    EXPECT_EQ(policy_called(name).latitude, Latitude::none);
  }
}

TEST(Galleries, EveryChoiceHasAReasonAndNothingElseHas) {
  for (const std::string& name : names_in("galleries")) {
    const Gallery gallery = gallery_called(name);
    const Policy policy = policy_called(name);
    EXPECT_GE(gallery.pictures.size(), 8U) << name;
    EXPECT_FALSE(gallery.about.empty()) << name;
    EXPECT_FALSE(gallery.sources.empty()) << name;
    for (const auto& [rule, alternative] : policy.rules)
      EXPECT_TRUE(gallery.choices.contains(rule)) << name << " chooses " << rule;
    for (const auto& [rule, words] : gallery.choices)
      EXPECT_TRUE(policy.rules.contains(rule)) << name << " has words on " << rule;
  }
}

TEST(Galleries, EveryChoiceBesideOpenGlsIsShownOrArgued) {
  for (const std::string& name : names_in("galleries")) {
    const Gallery gallery = gallery_called(name);
    const Policy policy = policy_called(name);
    const std::set<std::string> shown = shown_rules(gallery, policy);
    for (const ContrastingChoice& choice : contrasting_choices(policy, Surface::fbo))
      EXPECT_NE(shown.contains(choice.rule), gallery.not_shown.contains(choice.rule))
          << name << ": " << choice.rule << (shown.contains(choice.rule) ? " is" : " is not")
          << " seen in a picture";
    for (const auto& [rule, words] : gallery.not_shown)
      EXPECT_TRUE(policy.rules.contains(rule)) << name << " has words on " << rule;
  }
}

// A picture that has a choice of its own shows it.
TEST(Galleries, WhatAPictureHasOtherwiseIsSeen) {
  int pictures = 0;
  for (const std::string& name : names_in("galleries")) {
    const Gallery gallery = gallery_called(name);
    const Policy policy = policy_called(name);
    for (const GalleryPicture& picture : gallery.pictures) {
      if (picture.rules.empty()) continue;
      ++pictures;
      const Scene scene = case_called(picture.case_id).scene;
      EXPECT_FALSE(
          is_same_picture(rasterize(scene, policy_of(policy, picture)), rasterize(scene, policy)))
          << name << ": " << picture.heading;
    }
  }
  EXPECT_GE(pictures, 4);
}

TEST(Galleries, HeadingsTellPicturesApart) {
  for (const std::string& name : names_in("galleries")) {
    std::set<std::string> headings;
    for (const GalleryPicture& picture : gallery_called(name).pictures)
      EXPECT_TRUE(headings.insert(picture.heading).second) << name << ": " << picture.heading;
  }
}

}  // namespace
}  // namespace edgecase
