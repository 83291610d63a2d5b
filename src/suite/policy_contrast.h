// SPDX-License-Identifier: MIT
//
// How a policy's picture of a scene differs from that of policy `opengl`, and which of its choices
// are the reason.
//
// The policy's own choices are replaced by OpenGL's, first one at a time, then two and three, and
// the scene is drawn exactly each time. So "with line.algorithm as OpenGL has it the two pictures
// are the same" is an observation. Other alternatives are not tried.
#pragma once

#include <string>
#include <vector>

#include "model/policy.h"
#include "model/rendering.h"
#include "model/scene.h"

namespace edgecase {

// A rule for which a policy names an alternative other than that of `opengl`.
struct ContrastingChoice {
  std::string rule;
  std::string alternative;
  std::string standard;  // OpenGL's
};

// In the catalogue's order. Rules that the policy does not name are left out, even if they follow a
// named one, as triangle.snap follows subpixel.snap.
std::vector<ContrastingChoice> contrasting_choices(const Policy& policy, Surface surface);

// The policy with the standard alternatives of these rules.
Policy with_standard(const Policy& policy, const std::vector<std::string>& rules);

// True if the colours and hit counts of all pixels are the same. Ignores depths, stencils and the
// details of fragments.
bool is_same_picture(const Rendering& a, const Rendering& b);

struct PolicyContrast {
  Rendering under_policy;
  Rendering under_opengl;
  bool is_same = true;
  // Rules each of which alone, with OpenGL's choice, makes the picture OpenGL's.
  std::vector<std::string> alone;
  // If there is no such rule: a smallest set of rules that does so together; all of the policy's
  // choices if more than three are needed.
  std::vector<std::string> together;
};

// `reported`: the sample positions of the renderer in question, as for rasterize().
PolicyContrast contrast_with_opengl(const Scene& scene, const Policy& policy,
                                    const SamplePositions& reported = {});

}  // namespace edgecase
