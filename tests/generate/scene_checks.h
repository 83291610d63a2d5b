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
// a square power of two from 4 to 256, the viewport as large, every vertex strictly inside.
std::string fault_of(const Scene& scene);

// The same of clip coordinates alone, computed as OpenGL does: is one rounded on its way to clip
// coordinates, or back to window coordinates?
std::string rounding_of(const Scene& scene);

// A number that depends on every vertex, size and state of a scene, and on nothing else.
std::uint64_t fingerprint_of(const Scene& scene);

}  // namespace edgecase
