// SPDX-License-Identifier: MIT
//
// What two primitives of a scene break together, though each of them alone may hold every other
// ruling: connected lines ruling 14, triangles with a common edge ruling 5.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "diff/coverage/coverage_diff.h"
#include "model/scene.h"

namespace edgecase {

struct JointFault {
  int first = 0;  // primitive indices
  int second = 0;
  std::string clause;                      // what the segments as given break, or empty
  std::vector<std::string> illegal_snaps;  // catalogued snaps under which they break a clause
};

// Every pair of lines of width 1 that ruling 14 speaks of and that breaks it under some snap.
std::vector<JointFault> joint_faults(std::span<const ScenePrimitive> primitives,
                                     std::span<const PrimitiveCoverage> coverage,
                                     const Scene& scene);

// ------------------------------------------------------------------------------------ shared edges
//
// Only triangles with a common edge have something in common to break, so each is looked up by its
// directed edges: the work grows with the triangles and their common edges, not with all pairs.

// Samples that two triangles with a common edge must hit exactly once but hit otherwise.
struct SharedEdgeFault {
  PixelPosition pixel;
  int sample = 0;
  int first = 0;  // primitive indices
  int second = 0;
  int hits = 0;  // by the two together
  // It is a fault wherever the points lie by which coverage is found, and not only where samples
  // are reported to lie (ruling 47).
  bool is_certain = true;
};

// In the order of the first triangle, then the second, then sample, row and column. `bits` as in
// ruling 4; `positions`: where the target's samples lie.
std::vector<SharedEdgeFault> shared_edge_faults(
    std::span<const ScenePrimitive> primitives, std::span<const PrimitiveCoverage> coverage,
    const Scene& scene, int bits, const SamplePositions& positions = {centre_of_pixel()});

// Pairs of triangles, by their places in `primitives`, the lower one first, in ascending order:
// those that lie on opposite sides of a line between two points that are, to the nearest 1/65536
// pixel, vertices of both.
std::vector<std::pair<std::size_t, std::size_t>> neighbours(
    std::span<const ScenePrimitive> primitives);

}  // namespace edgecase
