// SPDX-License-Identifier: MIT
//
// The exact rasterizer as a renderer of textures to measure, and what is found of it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "profile/textures/texture_measurement.h"
#include "tests/profile/altered_renderer.h"

namespace edgecase {

inline Policy policy_of(const Choices& rules) {
  Policy policy;
  policy.rules = rules;
  return policy;
}

using Families = std::vector<std::string_view>;

// `families`: beginnings of the ids of the scenes that are drawn; without any, all are.
inline TextureFindings findings_of(const Choices& rules, Surface surface = Surface::fbo,
                                   const Families& families = {}, const Alter& alter = {}) {
  AlteredRenderer renderer(policy_of(rules), alter, [&](const Task& task) {
    return families.empty() || std::ranges::any_of(families, [&](std::string_view family) {
             return task.id.starts_with(family);
           });
  });
  TextureMeasureQuestion question;
  question.surface = surface;
  question.scenes_per_kind = 100;
  question.found = resolve(policy_of(rules), surface);
  question.found.textures = TextureChoice{};
  std::size_t told = 0;
  TextureFindings findings = measure_textures(
      renderer, question, [&](std::size_t more) { told += more; }, nullptr);
  EXPECT_EQ(told, texture_scene_count(question.scenes_per_kind));
  EXPECT_EQ(findings.scenes + findings.not_drawn, told);
  if (families.empty()) {
    EXPECT_EQ(findings.not_drawn, 0u);
  }
  return findings;
}

// Of scenes that tell what is put wrong, and no others.
inline TextureFindings findings_among(const Families& families, const Choices& rules,
                                      const Alter& alter) {
  return findings_of(rules, Surface::fbo, families, alter);
}

inline const Trait& trait_of(const TextureFindings& findings, const std::string& id) {
  for (const Trait& trait : findings.traits)
    if (trait.id == id) return trait;
  ADD_FAILURE() << "no trait " << id;
  static const Trait none;
  return none;
}

// Found, agreed with by all that tells, and by nothing as well as by it.
inline void expect_found(const TextureFindings& findings, const std::string& id,
                         const std::string& alternative) {
  const Trait& trait = trait_of(findings, id);
  EXPECT_EQ(trait.alternative, alternative) << id;
  EXPECT_GT(trait.rate.of, 50u) << id;
  EXPECT_EQ(trait.rate.agreeing, trait.rate.of) << id << " " << trait.remark;
  EXPECT_LT(trait.runner_up_rate.agreeing, trait.rate.agreeing) << id << " " << trait.runner_up;
  EXPECT_EQ(findings.choices.at(id), alternative) << id;
}

}  // namespace edgecase
