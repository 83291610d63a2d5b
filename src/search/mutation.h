// SPDX-License-Identifier: MIT
//
// Mutation: a copy of a scene with a small change.
//
// Scenes near to one that shows something often show more: with a vertex moved by a sub-pixel step
// or onto the next tie, a primitive removed or doubled, another order, width or number of samples,
// or everything transposed, mirrored or moved by whole pixels.
#pragma once

#include <optional>

#include "generate/random_scenes.h"
#include "model/scene.h"

namespace edgecase {

// Applies one to three changes. A case file can express the result, so its coordinates reach OpenGL
// unrounded; nothing if no such scene was found in a few tries. The result depends only on the
// scene and the random numbers. Vertices given as clip coordinates are not moved.
std::optional<Scene> mutated(const Scene& scene, RandomSource& random);

}  // namespace edgecase
