// SPDX-License-Identifier: MIT
//
// The measurement of values on one surface.
//
//   samples of renderings -> traits, derivatives, depth buffers -> all fragments -> errors
//
// Renderings are dropped as they are counted.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "model/renderer.h"
#include "profile/observation.h"
#include "profile/profile.h"
#include "profile/values/value_errors.h"
#include "rules/choices.h"

namespace edgecase {

struct ValueQuestion {
  std::uint64_t seed = 1;
  Surface surface = Surface::fbo;
  std::size_t scenes_per_kind = 20'000;  // as in MeasureOptions; far fewer are drawn
  RuleChoices found;                     // coverage and snapping
  int bits = 4;                          // as in ruling 4
};

struct ValueFindings {
  std::vector<Trait> traits;
  Choices choices;  // of those traits that something was learnt of
  std::vector<ValueErrors> errors;
  std::size_t scenes = 0;  // that were drawn
  std::size_t not_drawn = 0;
  std::string first_failure;  // of those not drawn, but of unavailable depth formats
};

// How many scenes of each mode errors are counted in.
std::size_t error_scene_count(std::size_t scenes_per_kind);

// How many scenes measure_values draws, but for a few that it draws again alone.
std::size_t value_scene_count(std::size_t scenes_per_kind);

ValueFindings measure_values(Renderer& renderer, const ValueQuestion& question,
                             const ObservationProgress& progress, const std::atomic<bool>* stop);

}  // namespace edgecase
