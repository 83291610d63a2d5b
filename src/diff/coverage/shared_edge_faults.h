// SPDX-License-Identifier: MIT
//
// Ruling 5, which two triangles with a common edge can break together, though each of them alone
// may satisfy every other ruling.
//
// Triangles are looked up by their directed edges: the work grows with the triangles and their
// common edges, not with all pairs.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "diff/coverage/coverage_diff.h"
#include "model/scene.h"

namespace edgecase {

// A sample that two triangles with a common edge must hit exactly once but do not.
struct SharedEdgeFault {
  PixelPosition pixel;
  int sample = 0;
  int first = 0;  // primitive indices
  int second = 0;
  int hits = 0;  // by the two together
  // The fault does not depend on where coverage is found; false if it holds only for samples at
  // their reported positions (ruling 47).
  bool is_certain = true;
};

// Those of clipped triangles (diff/coverage/clipped_seams.h) last. `bits` as in ruling 4;
// `positions`: those of the target's samples. If exact draws as the specification's own rule does,
// which leaves no fault, set `exact_has_none`: then two triangles drawn as exact draws them are
// passed over.
std::vector<SharedEdgeFault> shared_edge_faults(
    std::span<const ScenePrimitive> primitives, std::span<const PrimitiveCoverage> coverage,
    const Scene& scene, int bits, const SamplePositions& positions = {centre_of_pixel()},
    bool exact_has_none = false);

// Pairs of triangles by index in `primitives`, the lower one first, in ascending order: those on
// opposite sides of a line between two points that are, to the nearest 1/65536 pixel, vertices of
// both.
std::vector<std::pair<std::size_t, std::size_t>> neighbours(
    std::span<const ScenePrimitive> primitives);

}  // namespace edgecase
