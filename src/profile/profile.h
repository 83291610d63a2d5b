// SPDX-License-Identifier: MIT
//
// Profile: the policy that a renderer is measured to follow, with the evidence.
//
// Traits are found, not asked for: a renderer that reports 4 sub-pixel bits and rounds to 8 has 8
// in its profile. What no combination of catalogued alternatives draws stays a counter-example,
// sorted into clusters, each with its smallest scene; nothing is forced to fit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "model/policy.h"
#include "model/renderer.h"
#include "model/scene.h"
#include "profile/inference.h"
#include "profile/output/output_profile.h"
#include "profile/samples/sample_profile.h"
#include "profile/textures/texture_residuals.h"
#include "profile/values/value_errors.h"
#include "results/clusters.h"

namespace edgecase {

// One finding about one surface.
struct Trait {
  std::string id;           // a rule's id, "line.joint", or what was probed: "clip.triangle"
  std::string alternative;  // the alternative that is followed, or the finding in words
  Rate rate;                // of the scenes (or pixels, for probes of one pixel) that agree with it
  std::string runner_up;    // the best other alternative; empty: there is none to compare with
  Rate runner_up_rate;
  std::string remark;  // what people should know, a sentence; often empty

  // Could the runner-up just as well be it?
  bool is_undecided() const {
    return !runner_up.empty() && rate.agreeing == runner_up_rate.agreeing;
  }
};

// Who owns the parts of a boundary: what was seen at probes, by row and column.
struct OwnershipTable {
  struct Cell {
    std::size_t drawn = 0;
    std::size_t of = 0;
  };
  std::string title;  // "start of a line on its pixel's diamond"
  std::vector<std::string> rows;
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> cells;  // [row][column]
};

// Counter-examples that share a cause or a situation.
struct ProfileCluster {
  Cluster cluster;
  Scene smallest;
};

struct SurfaceProfile {
  Surface surface = Surface::fbo;
  std::string unavailable;  // why nothing could be measured; empty: it could
  std::size_t scenes = 0;   // that were drawn
  std::size_t not_drawn = 0;
  std::string first_failure;  // of those not drawn
  std::size_t with_ties = 0;  // random scenes with a tie, of random_scenes
  std::size_t random_scenes = 0;
  std::vector<Trait> traits;
  std::vector<OwnershipTable> tables;
  std::vector<ValueErrors> values;
  std::vector<LevelResiduals> levels;
  SampleProfile samples;
  OutputProfile output;
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

}  // namespace edgecase
