// SPDX-License-Identifier: MIT
//
// Random fragment operations for tests.
#pragma once

#include "model/scene.h"
#include "tests/raster/random_scenes.h"

namespace edgecase {

FragmentOperations random_operations(RandomScenes& random);

// Gives a scene's draws random operations, a random facing and colours between which blending tells
// differences; buffers, what they are cleared to, and depths of which many are equal.
void give_operations(Scene& scene, RandomScenes& random);

}  // namespace edgecase
