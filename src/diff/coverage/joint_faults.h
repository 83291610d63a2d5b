// SPDX-License-Identifier: MIT
//
// Ruling 14, which two connected lines of a scene can break together, though each of them alone may
// satisfy every other ruling.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "diff/coverage/coverage_diff.h"
#include "model/scene.h"

namespace edgecase {

struct JointFault {
  int first = 0;  // primitive indices
  int second = 0;
  std::string clause;                      // which the segments as given break, or empty
  std::vector<std::string> illegal_snaps;  // catalogued snaps under which they break a clause
};

// Every pair of lines of width 1 that ruling 14 applies to and that breaks it under some snap.
std::vector<JointFault> joint_faults(std::span<const ScenePrimitive> primitives,
                                     std::span<const PrimitiveCoverage> coverage,
                                     const Scene& scene);

}  // namespace edgecase
