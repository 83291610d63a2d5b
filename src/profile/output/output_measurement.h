// SPDX-License-Identifier: MIT
//
// The measurement of fragment operations on one surface.
//
//   plain colours, masks -> blending -> depth codes, depth test -> stencil test -> polygon offset
//     -> random scenes under all that was found
//
// A depth format that a surface does not have is left out, and said so.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/renderer.h"
#include "profile/observation.h"
#include "profile/output/output_profile.h"
#include "profile/profile.h"
#include "profile/scene_drawing.h"

namespace edgecase {

struct OutputFindings {
  OutputProfile profile;
  std::vector<Trait> traits;
  Choices choices;    // of those traits that name a rule, and that an alternative fits
  DrawnCounts drawn;  // but for depth formats that are not there
};

struct OutputMeasureQuestion {
  std::uint64_t seed = 1;
  Surface surface = Surface::fbo;
  std::size_t scenes_per_kind = 20'000;  // as in MeasureOptions; a twentieth is drawn of each kind
  Choices found;                         // coverage, values and samples
};

// How many scenes measure_output draws of a renderer that has all depth formats.
std::size_t output_scene_count(std::size_t scenes_per_kind);

OutputFindings measure_output(Renderer& renderer, const OutputMeasureQuestion& question,
                              const ObservationProgress& progress, const std::atomic<bool>* stop);

}  // namespace edgecase
