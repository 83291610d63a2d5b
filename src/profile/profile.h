// SPDX-License-Identifier: MIT
//
// Profile: the policy that a renderer is measured to follow, with the evidence.
//
//   coverage -> clipping -> values -> textures -> multisampled targets -> fragment operations
//     -> counter-examples, clusters
//
// Traits are measured, regardless of a renderer's claims: one that reports 4 sub-pixel bits and
// rounds to 8 has 8 in its profile. Results that no combination of catalogued alternatives draws
// stay counter-examples, sorted into clusters with their smallest scenes; nothing is forced to fit.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "model/policy.h"
#include "model/renderer.h"
#include "model/scene.h"
#include "profile/evidence/findings.h"
#include "results/clusters.h"

namespace edgecase {

// Counter-examples that share a cause or a situation.
struct ProfileCluster {
  Cluster cluster;
  Scene smallest;
};

struct SurfaceProfile {
  Surface surface = Surface::fbo;
  std::string unavailable;  // why nothing could be measured; otherwise empty
  SurfaceFindings findings;
  std::size_t illegal_scenes = 0;        // with something outside the specification
  std::vector<ProfileCluster> clusters;  // of deviations from the profile, and of what is illegal
};

struct Profile {
  RendererInfo renderer;
  std::uint64_t seed = 1;
  std::size_t scenes_per_kind = 0;
  std::vector<SurfaceProfile> surfaces;
  Policy policy;  // the argument of `--policy`
};

struct MeasureOptions {
  std::string name;  // of the renderer, for the policy
  std::uint64_t seed = 1;
  std::size_t scenes_per_kind = 20'000;  // random scenes of each primitive type and surface
  std::vector<Surface> surfaces = {Surface::fbo, Surface::window};
  int jobs = 2;
  std::function<void(std::size_t done, std::size_t total)> progress;  // scenes; from any thread
  const std::atomic<bool>* stop = nullptr;
};

// Measures all surfaces in parallel, each with its own renderer. Equal renderers, seeds and numbers
// of scenes give equal profiles, whatever the number of threads. Throws MeasurementStopped once
// `stop` is true.
Profile measure(const MakeRenderer& make_renderer, const MeasureOptions& options);

}  // namespace edgecase
