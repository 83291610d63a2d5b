// SPDX-License-Identifier: MIT
//
// Ruling 5 of triangles that reach out of the clip volume: the seam of two triangles is the edge
// between the same two vertices, bit for bit, whatever clipping makes of it.
//
//   vertices -> pairs -> visible polygons -> samples near the seam, clear of all other edges
#pragma once

#include <span>
#include <vector>

#include "diff/coverage/coverage_diff.h"
#include "diff/coverage/shared_edge_faults.h"
#include "model/scene.h"

namespace edgecase {

// Samples that two triangles, at least one of them clipped, must hit once together but do not,
// sorted as shared_edge_faults has them. A sample counts that lies in the viewport, nearer to the
// seam than its latitude, and strictly inside all other edges of both visible polygons for all
// moves that rulings 4 and 42 allow. The rest as in shared_edge_faults.
std::vector<SharedEdgeFault> clipped_seam_faults(std::span<const ScenePrimitive> primitives,
                                                 std::span<const PrimitiveCoverage> coverage,
                                                 const Scene& scene, int bits,
                                                 const SamplePositions& positions,
                                                 bool exact_has_none);

}  // namespace edgecase
