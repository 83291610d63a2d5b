// SPDX-License-Identifier: MIT
//
// A scene's vertices as the vertex shader gets them.
//
// Strips, fans and loops are drawn by the GL from the draw's own vertices, so a vertex can belong
// to three primitives. The number that fragments carry is a flat attribute, which the GL takes from
// the provoking vertex, and under either convention each vertex provokes at most one primitive
// (GL 4.6 core, table 13.2): it carries that one's number. Where every primitive has vertices of
// its own, all of them carry the number, which then does not depend on the driver's idea of
// provoking.
#pragma once

#include <cstdint>
#include <vector>

#include "model/scene.h"

namespace edgecase {

struct GpuVertex {
  float clip[4];   // a vertex's own clip coordinates as they are, or those of its window position
  float color[4];  // or s, t, 0 and 1, where the draw is textured
  std::int32_t primitive;  // kNoPrimitive where the vertex provokes none
};

constexpr std::int32_t kNoPrimitive = -1;

// All draws' vertices, one after the other.
std::vector<GpuVertex> gpu_vertices(const Scene& scene);

}  // namespace edgecase
