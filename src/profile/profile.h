// SPDX-License-Identifier: MIT
//
// Profile: the policy that a renderer is measured to follow, with the evidence.
//
//   coverage -> clipping -> values -> textures -> multisampled targets -> fragment operations
//     -> counter-examples, clusters
//
// Traits are measured, whatever a renderer claims: one that reports 4 sub-pixel bits and rounds to
// 8 has 8 in its profile. What no combination of catalogued alternatives draws stays a
// counter-example, sorted into clusters, each with its smallest scene; nothing is forced to fit.
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
  std::string unavailable;  // why nothing could be measured; empty: it could
  SurfaceFindings findings;
  std::size_t illegal_scenes = 0;        // in which something is outside the specification
  std::vector<ProfileCluster> clusters;  // of what differs from the profile, or is illegal
};

struct Profile {
  RendererInfo renderer;
  std::uint64_t seed = 1;
  std::size_t scenes_per_kind = 0;
  std::vector<SurfaceProfile> surfaces;
  Policy policy;  // what `--policy` takes
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

// Measures all surfaces side by side, each with a renderer of its own. The same renderer, seed and
// number of scenes give the same profile, whatever the number of threads. Throws MeasurementStopped
// when `stop` became true.
Profile measure(const MakeRenderer& make_renderer, const MeasureOptions& options);

}  // namespace edgecase
