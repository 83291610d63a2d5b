// SPDX-License-Identifier: MIT
//
// What a policy draws of a scene otherwise than policy `opengl`, and which of its choices does it.
//
// No cause is searched among all alternatives: the policy's own choices are put back to OpenGL's,
// one at a time, then two and three, and the scene is drawn exactly each time. So "with
// line.algorithm as OpenGL has it the two pictures are the same" is a plain observation.
#pragma once

#include <string>
#include <vector>

#include "model/policy.h"
#include "model/rendering.h"
#include "model/scene.h"

namespace edgecase {

// A rule of which a policy names another alternative than `opengl` has.
struct ContrastingChoice {
  std::string rule;
  std::string alternative;
  std::string standard;  // OpenGL's
};

// In the catalogue's order. A rule that the policy does not name is none, even where it follows
// another: triangle.snap where subpixel.snap is named.
std::vector<ContrastingChoice> contrasting_choices(const Policy& policy, Surface surface);

// The policy with the standard alternatives of these rules.
Policy with_standard(const Policy& policy, const std::vector<std::string>& rules);

// Are the colours of all pixels the same, and is each pixel drawn as often? Depths, stencils and
// what fragments tell are not looked at.
bool is_same_picture(const Rendering& a, const Rendering& b);

struct PolicyContrast {
  Rendering under_policy;
  Rendering under_opengl;
  bool is_same = true;
  // Rules each of which, put back alone, makes the picture OpenGL's.
  std::vector<std::string> alone;
  // Where none does alone: a smallest set of rules that does together; all of the policy's choices
  // where more than three are needed.
  std::vector<std::string> together;
};

// `reported`: where the renderer beside them says that samples lie, as rasterize has it.
PolicyContrast contrast_with_opengl(const Scene& scene, const Policy& policy,
                                    const SamplePositions& reported = {});

}  // namespace edgecase
