// SPDX-License-Identifier: MIT
//
// Measure: from a renderer to its profile.
//
//   generated scenes -> observed coverage -> inferred choice -> probes -> clipping -> values ->
//   textures -> multisampled targets -> fragment operations -> counter-examples, clusters
//
// Both surfaces are measured side by side, each with a renderer of its own. The same renderer, seed
// and number of scenes give the same profile, whatever the number of threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "profile/observation.h"
#include "profile/profile.h"

namespace edgecase {

struct MeasureOptions {
  std::string name;  // of the renderer, for the policy
  std::uint64_t seed = 1;
  std::size_t scenes_per_kind = 20'000;  // random scenes of each primitive type and surface
  std::vector<Surface> surfaces = {Surface::fbo, Surface::window};
  int jobs = 2;
  std::function<void(std::size_t done, std::size_t total)> progress;  // scenes; from any thread
  const std::atomic<bool>* stop = nullptr;
};

// Throws MeasurementStopped when `stop` became true.
Profile measure(const MakeRenderer& make_renderer, const MeasureOptions& options);

}  // namespace edgecase
