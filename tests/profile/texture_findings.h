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

#include "profile/evidence/inference.h"
#include "profile/textures/textures.h"
#include "tests/profile/altered_renderer.h"
#include "tests/profile/found_traits.h"

namespace edgecase {

using Families = std::vector<std::string_view>;

// `families`: beginnings of the ids of the scenes that are drawn; without any, all are.
inline SurfaceFindings findings_of(const Choices& rules, Surface surface = Surface::fbo,
                                   const Families& families = {}, const Alter& alter = {}) {
  AlteredRenderer renderer(policy_of(rules), alter, [&](const Task& task) {
    return families.empty() || std::ranges::any_of(families, [&](std::string_view family) {
             return task.id.starts_with(family);
           });
  });
  SurfaceFindings before;
  before.found = resolve(policy_of(rules), surface);
  before.found.textures = TextureChoice{};
  SurfaceFindings findings =
      measured(kTextureSubject, renderer, {1, surface, 100}, std::move(before));
  EXPECT_EQ(findings.drawn.scenes + findings.drawn.not_drawn, kTextureSubject.scene_count(100));
  if (families.empty()) {
    EXPECT_EQ(findings.drawn.not_drawn, 0u);
  }
  return findings;
}

// Of scenes that tell what is put wrong, and no others.
inline SurfaceFindings findings_among(const Families& families, const Choices& rules,
                                      const Alter& alter) {
  return findings_of(rules, Surface::fbo, families, alter);
}

}  // namespace edgecase
