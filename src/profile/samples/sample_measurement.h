// SPDX-License-Identifier: MIT
//
// The measurement of multisampled targets on one surface.
//
//   numbers of samples -> sweeps -> placement -> random triangles and lines -> GL_MULTISAMPLE,
//   sample mask -> invocations -> attributes, depths -> alpha to coverage -> resolve
//
// Answers about multisampled targets are whole, so they cost more than those of coverage alone:
// random targets are smaller, and far fewer scenes are drawn than of single-sampled targets.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "model/renderer.h"
#include "profile/observation.h"
#include "profile/profile.h"
#include "profile/samples/sample_profile.h"
#include "profile/scene_drawing.h"
#include "rules/choices.h"

namespace edgecase {

struct SampleFindings {
  SampleProfile profile;
  std::vector<Trait> traits;
  std::vector<OwnershipTable> tables;
  Choices choices;  // of those traits that name a rule and that something was learnt of
  std::vector<Observation> observations;  // of random scenes
  DrawnCounts drawn;                      // but for numbers of samples that are not made
};

struct SampleMeasureQuestion {
  std::uint64_t seed = 1;
  Surface surface = Surface::fbo;
  std::size_t scenes_per_kind = 20'000;  // as in MeasureOptions; a quarter is drawn
  Choices found;                         // of targets of one sample
};

// How many scenes measure_samples draws of a renderer that makes one number of samples.
std::size_t sample_scene_count(std::size_t scenes_per_kind);

SampleFindings measure_samples(Renderer& renderer, const SampleMeasureQuestion& question,
                               const ObservationProgress& progress, const std::atomic<bool>* stop);

}  // namespace edgecase
