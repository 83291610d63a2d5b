// SPDX-License-Identifier: MIT
//
// Sample traits: which alternatives of the rules for multisampled targets a renderer follows.
//
// An alternative yields what is told where the exact rasterizer under it, everything else as found
// so far, has the same: a pixel's invocations, a colour or depth to within 1/64 pixel of where it
// was evaluated, the samples that a pixel's fragments write.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "profile/profile.h"
#include "profile/samples/sample_profile.h"
#include "profile/samples/sample_scenes.h"
#include "profile/scene_drawing.h"
#include "rules/choices.h"

namespace edgecase {

// What of a rendering a rule is held against.
enum class ToldOf {
  invocations,      // of each pixel
  colors,           // of each fragment of a plane scene
  fragment_depths,  // of each fragment of a plane scene
  sample_depths,    // of each sample that was written
  all_depths,       // both
  writes,           // how often each sample of each pixel was written
  switched_off,     // invocations, and depths of samples
};

// `found`: the rules found so far.
Trait infer_sample_rule(const std::string& rule, std::string id, ToldOf what,
                        std::span<const DrawnScene> told, const Choices& found);

// Of multisampled lines: does the rule attribute.smooth choose for them as it does for those of one
// sample? Those of its alternatives and of attribute.location's that together yield most colours.
Trait infer_line_parameter(std::span<const DrawnScene> lines, const Choices& found);

// sample.resolve, by the samples that the renderer tells.
Trait infer_resolve(std::span<const DrawnScene> told);

// Does alpha to coverage keep each sample by the alpha of its own invocation? Of pixels of which
// the shader runs for each sample.
Trait own_alpha_trait(std::span<const DrawnScene> told, AlphaToCoverage choice);

// Masks by alpha, of alpha scenes whose alphas follow each other.
std::vector<AlphaRun> alpha_runs(std::span<const DrawnScene> told);

// Who owns samples on each part of a line's boundary.
OwnershipTable line_side_table(std::span<const LineSideProbe> probes,
                               std::span<const Observation> observations);
// In how many probes the choice covers the probed sample, or leaves it out, as the renderer does.
Trait line_side_trait(std::span<const LineSideProbe> probes,
                      std::span<const Observation> observations, const CoverageChoice& lines);

}  // namespace edgecase
