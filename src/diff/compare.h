// SPDX-License-Identifier: MIT
//
// Compare: everything that one renderer's answer to one case shows by itself.
//
//   match -> legality, cause, explanation per difference -> values -> Result (not judged yet)
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "model/figure.h"
#include "model/renderer.h"
#include "model/rendering.h"
#include "model/result.h"
#include "model/scene.h"
#include "rules/all_rules.h"
#include "rules/choices.h"
#include "rules/renderer_claims.h"
#include "rules/textures/level_of_detail.h"

namespace edgecase {

// Facts about the renderer, apart from its rendering.
struct RendererFacts {
  int reported_subpixel_bits = 4;
  const ResolvedPolicy* profile = nullptr;  // the policy it is measured to follow; null: unknown
  SupportedSizes sizes = {};                // supported sizes of points and multisampled lines
  LookupLimits lookups = {};                // limits on levels of detail
  bool likely_first = true;                 // look for causes in the profile first
};

// Reads the facts that a renderer states. `profile` must outlive the result.
RendererFacts facts_of(const RendererInfo& info, const ResolvedPolicy* profile);

// Compares a rendering of `scene` with the exact one under `policy`. Both must have the scene's
// size and only primitives of the scene. judge() decides the verdict later, and whoever keeps
// results adds the pictures (run/comparing.h).
Result compare(const Scene& scene, const ResolvedPolicy& policy, const Rendering& exact,
               const Rendering& rendered, const RendererFacts& facts);

// The result of a scene that has no rendering.
Result not_run(Failure failure);

// The outlines of a scene's primitives and their vertices; each position is marked once.
Figure scene_figure(const Scene& scene);

// Why each primitive does or does not draw pixel (x, y) under a policy, or each of its samples if
// the primitive is multisampled: a sentence each, with the rule's figure.
struct PixelExplanation {
  int primitive = 0;
  int sample = -1;  // -1: the pixel
  bool covered = false;
  RuleId rule;
  std::string text;
  Figure figure;
};

std::vector<PixelExplanation> explain_pixel(const Scene& scene, const ResolvedPolicy& policy, int x,
                                            int y);

// The number of pixels that are equal in all four bytes in two RGBA8 pictures. Pixels that only one
// of the pictures has count as different.
//
// Pictures are compared block by block: most blocks of most pictures are equal, which memcmp finds
// as fast as memory can be read. Only the other blocks are compared pixel by pixel.
std::size_t count_same_pixels(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b);

}  // namespace edgecase
