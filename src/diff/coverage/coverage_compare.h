// SPDX-License-Identifier: MIT
//
// Coverage: which fragments differ, whether that is legal, and which alternatives explain it.
//
// Two questions are asked of every primitive. Does the renderer draw what the policy says? And is
// what it draws inside the specification? A policy that OpenGL judges (latitude `opengl`) cannot
// excuse what OpenGL forbids: a primitive that agrees with the policy and breaks a ruling is held
// against the specification's own choice instead, and disagrees.
#pragma once

#include <span>

#include "diff/coverage/coverage_diff.h"
#include "diff/coverage/supported_sizes.h"
#include "model/policy.h"
#include "model/result.h"
#include "model/scene.h"
#include "rules/choices.h"

namespace edgecase {

// What the comparison of coverage needs of a case.
struct CoverageContext {
  const Scene& scene;
  std::span<const ScenePrimitive> primitives;
  std::span<const PrimitiveCoverage> coverage;  // by primitive; `exact` is what the policy draws
  RuleChoices choices;                          // of the policy
  const RuleChoices* profile = nullptr;         // of the renderer, where it is known
  Latitude latitude = Latitude::opengl;
  int bits = 4;                // as in ruling 4
  bool refute = true;          // gather evidence against alternatives; costs more than all the rest
  SamplePositions reported{};  // where the renderer says that samples lie
  SupportedSizes sizes{};      // of points and multisampled lines
};

// Appends disagreements and evidence to `result`, and fills illegal_line_snaps and refuted.
void compare_coverage(const CoverageContext& context, Result& result);

}  // namespace edgecase
