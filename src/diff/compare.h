// SPDX-License-Identifier: MIT
//
// Compare: everything that can be said of one renderer's answer to one case by itself.
//
//   match -> legality, cause, explanation per difference -> values -> Result (not judged yet)
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "diff/coverage/supported_sizes.h"
#include "model/figure.h"
#include "model/renderer.h"
#include "model/rendering.h"
#include "model/result.h"
#include "model/scene.h"
#include "rules/choices.h"
#include "rules/textures/level_of_detail.h"

namespace edgecase {

// What is known of the renderer beside the rendering.
struct RendererFacts {
  int reported_subpixel_bits = 4;
  const ResolvedPolicy* profile = nullptr;  // what it is measured to follow; null: not known
  SupportedSizes sizes = {};                // of points and of multisampled lines
  LookupLimits lookups = {};                // of levels of detail
};

// What a renderer says of itself. `profile` must outlive it.
RendererFacts facts_of(const RendererInfo& info, const ResolvedPolicy* profile);

// Compares a rendering of `scene` with the exact one under `policy`. Both must have the scene's
// size and only primitives of the scene. The verdict stays open until judge(), and pictures are
// left to those who keep results (run/comparing.h).
Result compare(const Scene& scene, const ResolvedPolicy& policy, const Rendering& exact,
               const Rendering& rendered, const RendererFacts& facts);

// The result of a scene that has no rendering.
Result not_run(Failure failure);

// The outlines of a scene's primitives and their vertices, each place marked once.
Figure scene_figure(const Scene& scene);

// Why pixel (x, y), of multisampled primitives each of its samples, is or is not drawn by each
// primitive under a policy: a sentence each, with the rule's figure.
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

// ------------------------------------------------------------------------------------ equal pixels
//
// Pictures held against each other block by block: most blocks of most pictures are the same, which
// memcmp says as fast as memory can be read, and only the others are looked at pixel by pixel.

// How many pixels of two RGBA8 pictures are the same in all four bytes; of pictures of different
// sizes, pixels that one of them lacks differ.
std::size_t count_same_pixels(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b);

}  // namespace edgecase
