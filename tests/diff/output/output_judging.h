// SPDX-License-Identifier: MIT
//
// Judging renderings of scenes with fragment operations.
#pragma once

#include <string>

#include "model/scene.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/judging.h"

namespace edgecase {

// A random scene with operations, culling and polygon offsets.
Scene random_output_scene(RandomScenes& random, int size = 10);
// The same, multisampled, of triangles.
Scene random_multisampled_output_scene(RandomScenes& random);

// Held against exact under a policy, and judged alone.
Result judge_output(const Scene& scene, const Policy& policy, const Rendering& rendered,
                    Latitude latitude = Latitude::opengl, int subpixel_bits = 8);

// All that was found, for messages.
std::string described(const Result& result);

}  // namespace edgecase
