// SPDX-License-Identifier: MIT
//
// A scene's vertices as inputs of the vertex shader.
//
// The GL draws strips, fans and loops from the draw's own vertices, so a vertex can belong to three
// primitives. The number that fragments carry is a flat attribute, which the GL takes from the
// provoking vertex, and under either convention each vertex provokes at most one primitive (GL 4.6
// core, table 13.2): it carries that one's number. If every primitive has separate vertices, all of
// them carry the number, which then does not depend on which vertex the driver lets provoke.
#pragma once

#include <cstdint>
#include <vector>

#include "model/scene.h"

namespace edgecase {

struct GpuVertex {
  float clip[4];           // a vertex's own clip coordinates, or those of its window position
  float color[4];          // or s, t, 0 and 1 in a textured draw
  std::int32_t primitive;  // kNoPrimitive if the vertex provokes none
};

constexpr std::int32_t kNoPrimitive = -1;

// All draws' vertices, one after the other.
std::vector<GpuVertex> gpu_vertices(const Scene& scene);

}  // namespace edgecase
