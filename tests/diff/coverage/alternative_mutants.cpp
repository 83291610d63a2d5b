// SPDX-License-Identifier: MIT
//
// What the exact rasterizer itself draws under other alternatives: the cause is known, and must be
// found.
#include "raster/rasterizer.h"
#include "tests/diff/coverage/fragment_changes.h"

namespace edgecase {
namespace {

// Drawn under one alternative, which must be the cause; `rule` as in Mutant.
Mutant alternative(Verdict verdict, const char* scene, const std::string& choice,
                   const std::string& option, const char* rule) {
  Mutant mutant;
  mutant.name = choice + "=" + option;
  mutant.scenes = {scene};
  mutant.verdict = verdict;
  mutant.rule = rule;
  mutant.cause = mutant.name;
  mutant.mutate = [=](const Scene& s, const Rendering&) {
    Policy policy;
    policy.rules[choice] = option;
    return rasterize(s, policy);
  };
  return mutant;
}

}  // namespace

std::vector<Mutant> alternative_mutants() {
  constexpr auto kViolation = Verdict::violation;
  constexpr auto kPermitted = Verdict::permitted;
  constexpr auto kConvention = Verdict::convention;
  constexpr const char* kFill = "triangle.fill-rule";
  constexpr const char* kShared = "triangle.shared-edge";
  constexpr const char* kLine = "line.diamond-exit";
  constexpr const char* kJoint = "line.joint";
  constexpr const char* kPoint = "point.ownership";
  std::vector<Mutant> mutants = {
      // On a free edge a tie may go either way, but no conforming implementation is open or closed.
      alternative(kPermitted, "triangles with ties", kFill, "open", kFill),
      alternative(kPermitted, "triangles with ties", kFill, "closed", kFill),
      alternative(kViolation, "shared edge", kFill, "open", kShared),
      alternative(kViolation, "shared edge", kFill, "closed", kShared),
      alternative(kConvention, "shared edge", kFill, "right-bottom", kFill),
      // Of a renderer that reports 8 bits.
      alternative(kConvention, "triangles off the grid", "triangle.snap", "8-half-even", kFill),
      alternative(kViolation, "triangles off the grid", "triangle.snap", "4-half-even", kFill),
      alternative(kConvention, "lines off the grid", "line.snap", "8-truncate", kLine),
      alternative(kConvention, "lines off the grid", "line.snap", "4-truncate", kLine),
      alternative(kConvention, "line on a row's border", kLine, "right-bottom", kLine),
      alternative(kConvention, "points off the grid", "point.snap", "8-half-even", kPoint),
      alternative(kViolation, "points off the grid", "point.snap", "4-half-even", kPoint),
      // Both lines draw their first pixel, as exact does.
      alternative(kConvention, "lines from one point", "line.algorithm", "midpoint", kLine),
      // Two strips draw the joint twice.
      alternative(kViolation, "strip x-major", "line.algorithm", "walk-floor-to-floor", kJoint),
      alternative(kViolation, "strip y-major", "line.algorithm", "midpoint", kJoint),
      alternative(Verdict::contested, "line smooth", "attribute.smooth", "major-axis",
                  "attribute.smooth"),
      alternative(kViolation, "triangle", "attribute.provoking-vertex", "first", "attribute.flat"),
      alternative(kConvention, "points on borders", kPoint, "left-bottom", kPoint),
  };
  for (const char* order : {"left-bottom", "right-bottom", "right-top", "bottom-left",
                            "bottom-right", "top-left", "top-right"})
    mutants.push_back(alternative(kConvention, "triangles with ties", kFill, order, kFill));
  return mutants;
}

}  // namespace edgecase
