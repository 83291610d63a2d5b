// SPDX-License-Identifier: MIT
//
// The measurement of textures on one surface.
//
//   probes -> filters and their weights -> ramps -> level of detail -> ties of levels, biases,
//   anisotropy, mip chains -> more ramps -> residuals
//
// Renderings are dropped as they are counted.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "model/renderer.h"
#include "profile/observation.h"
#include "profile/profile.h"
#include "profile/textures/texture_residuals.h"
#include "rules/choices.h"

namespace edgecase {

struct TextureFindings {
  std::vector<Trait> traits;
  Choices choices;  // of those traits that name a rule and that something was learnt of
  std::vector<LevelResiduals> residuals;
  std::size_t scenes = 0;  // that were drawn
  std::size_t not_drawn = 0;
  std::string first_failure;  // of those not drawn
};

struct TextureMeasureQuestion {
  std::uint64_t seed = 1;
  Surface surface = Surface::fbo;
  std::size_t scenes_per_kind = 20'000;  // as in MeasureOptions; far fewer are drawn
  RuleChoices found;                     // all but textures
};

// How many scenes measure_textures draws, but for a few that it draws again alone.
std::size_t texture_scene_count(std::size_t scenes_per_kind);

TextureFindings measure_textures(Renderer& renderer, const TextureMeasureQuestion& question,
                                 const ObservationProgress& progress,
                                 const std::atomic<bool>* stop);

}  // namespace edgecase
