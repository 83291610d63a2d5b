// SPDX-License-Identifier: MIT
//
// Few random scenes tell most alternatives of coverage apart. Those that they do not tell are told
// by scenes that are searched for.
#include <gtest/gtest.h>

#include <string>

#include "profile/coverage/coverage.h"
#include "rules/choices.h"
#include "tests/profile/altered_renderer.h"
#include "tests/profile/found_traits.h"

namespace edgecase {
namespace {

constexpr std::size_t kAll = 2'000;

const Policy& planted() {
  static const Policy policy = policy_of({{"point.ownership", "left-bottom"},
                                          {"point.snap", "9-truncate"},
                                          {"line.snap", "8-half-up"},
                                          {"line.diamond-exit", "top-left"},
                                          {"triangle.fill-rule", "left-bottom"},
                                          {"triangle.snap", "8-half-even"}});
  return policy;
}

// What the renderer is found to follow of what was planted.
Choices found_with(std::size_t scenes, std::size_t searched) {
  AlteredRenderer renderer(planted(), {}, {});
  Question question;
  question.scenes_per_kind = scenes;
  question.searched_scenes = searched;
  SurfaceFindings findings;
  findings.found = resolve(Policy{}, question.surface);
  findings = measured(kCoverageSubject, renderer, question, std::move(findings));
  Choices found;
  for (const auto& [rule, alternative] : planted().rules) {
    const Trait& trait = trait_of(findings, rule);
    EXPECT_EQ(trait.rate.agreeing, trait.rate.of) << rule;
    found[rule] = trait.alternative;
  }
  return found;
}

TEST(TellingScenes, TellWhatAllScenesTell) {
  const Choices all = found_with(kAll, kAll);
  EXPECT_EQ(found_with(100, kAll), all);
  EXPECT_NE(found_with(100, 100), all);
}

}  // namespace
}  // namespace edgecase
