// SPDX-License-Identifier: MIT
//
// Counter-examples: scenes in which a renderer does not follow its own profile, or follows it
// beyond the specification, sorted into clusters.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "model/policy.h"
#include "profile/evidence/drawing.h"
#include "profile/profile.h"
#include "results/results.h"

namespace edgecase {

class CounterExamples {
 public:
  // `policy` is the profile; the reported sub-pixel bits are for ruling 4.
  CounterExamples(Policy policy, Surface surface, int reported_subpixel_bits);

  // Compares an observation with the profile and the specification, and keeps it if it fails.
  // Returns true if the profile draws every primitive as it was drawn.
  bool add(const Observation& observation);

  // Scenes with something that the specification does not allow, whatever the profile; valid after
  // clusters().
  std::size_t illegal_scenes() const { return illegal_scenes_; }
  // Judges the kept observations. Call once.
  std::vector<ProfileCluster> clusters();

 private:
  Policy policy_;
  Surface surface_;
  int bits_;
  RuleChoices choices_;
  RuleChoices standard_;
  std::vector<CaseResults> kept_;
  std::map<std::string, Scene> scenes_;  // by id
  std::size_t illegal_scenes_ = 0;
};

}  // namespace edgecase
