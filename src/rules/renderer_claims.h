// SPDX-License-Identifier: MIT
//
// What a renderer claims of itself, as far as the specification lets it excuse an answer.
//
// A claim is the renderer's own word, so it excuses no more than the text grants to a renderer of
// which it is true. One that no implementation may make excuses nothing, and users are told.
#pragma once

#include <string>
#include <vector>

#include "model/renderer.h"
#include "rules/textures/level_of_detail.h"

namespace edgecase {

// Sizes that a renderer supports (GL 4.6 core, 14.4.1, 14.5.2.3 and 14.5.4; table 23.55).
//
// Implementations need not support all sizes of points, nor all widths of multisampled lines, but
// 1: an unsupported size becomes the nearest supported one. GL_POINT_SIZE_GRANULARITY and
// GL_SMOOTH_LINE_WIDTH_GRANULARITY give the distance between supported sizes; others may be
// supported besides.

// Evenly spaced sizes, pixels, from `least` on, 0 or more. step 0: unknown; every size is taken as
// supported.
struct SizeSteps {
  double least = 1;
  double step = 0;
  friend bool operator==(const SizeSteps&, const SizeSteps&) = default;
};

struct SupportedSizes {
  SizeSteps points;
  SizeSteps lines;  // multisampled ones
  friend bool operator==(const SupportedSizes&, const SupportedSizes&) = default;
};

struct RendererClaims {
  // By the traits "point_size_steps" and "sampled_line_width_steps", as "1 by 0.125".
  SupportedSizes sizes;
  // By the traits "max_texture_lod_bias" and "api".
  LookupLimits lookups;
  // A sentence without full stop for each claim that excuses nothing, since the specification does
  // not allow it or the text cannot be read.
  std::vector<std::string> refused;
};

// A missing trait means that nothing is known.
RendererClaims claims_of(const RendererInfo& info);

}  // namespace edgecase
