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
#include "tests/profile/found_traits.h"

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

}  // namespace edgecase
