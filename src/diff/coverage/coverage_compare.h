// SPDX-License-Identifier: MIT
//
// Coverage: which fragments differ, whether that is legal, and which alternatives explain it.
//
// Each primitive is tested twice. Does the renderer draw what the policy says? And is what it draws
// inside the specification? A policy that OpenGL judges (latitude `opengl`) cannot excuse what
// OpenGL forbids: a primitive that agrees with the policy and breaks a ruling is compared with the
// specification's own choice instead, and disagrees.
#pragma once

#include <span>

#include "diff/coverage/coverage_diff.h"
#include "model/policy.h"
#include "model/result.h"
#include "model/scene.h"
#include "rules/choices.h"
#include "rules/renderer_claims.h"

namespace edgecase {

// A case, as the comparison of coverage needs it.
struct CoverageContext {
  const Scene& scene;
  std::span<const ScenePrimitive> primitives;
  std::span<const PrimitiveCoverage> coverage;  // by primitive; `exact` is what the policy draws
  RuleChoices choices;                          // of the policy
  const RuleChoices* profile = nullptr;         // of the renderer, if known
  Latitude latitude = Latitude::opengl;
  int bits = 4;                // as in ruling 4
  bool refute = true;          // gather evidence against alternatives: the larger part of the cost
  SamplePositions reported{};  // sample positions as the renderer reports them
  SupportedSizes sizes{};      // of points and multisampled lines
  bool likely_first = true;    // as in CauseQuestion
};

// Appends disagreements and evidence to `result`, and fills illegal_line_snaps and refuted.
void compare_coverage(const CoverageContext& context, Result& result);

}  // namespace edgecase
