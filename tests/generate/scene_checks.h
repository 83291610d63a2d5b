// SPDX-License-Identifier: MIT
//
// What every generated scene must satisfy.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "model/scene.h"

namespace edgecase {

// What is wrong with a scene's target, viewport and vertices; empty when nothing is. The target is
// a square power of two from 4 to `most`, the viewport as large, every vertex strictly inside.
std::string fault_of(const Scene& scene, int most = 256);

// Whether a tie decides a pixel or sample of the scene: some primitive covers different ones with
// all boundaries open than with all closed. Vertices are not snapped; lines follow the diamond-exit
// rule or, on multisampled targets, are rectangles. `samples`: their positions.
bool has_tie(const Scene& scene, const SamplePositions& samples = {});

// A number that depends on every vertex, size and state of a scene, and on nothing else.
std::uint64_t fingerprint_of(const Scene& scene);

}  // namespace edgecase
