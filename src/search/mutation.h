// SPDX-License-Identifier: MIT
//
// Mutation: a scene that is another one but for a small change.
//
// Scenes that are known to be telling have telling ones beside them: a vertex a sub-pixel step
// further on, or upon the next tie; a primitive less, or twice; another order, width, number of
// samples; the whole transposed, mirrored or moved by whole pixels.
#pragma once

#include <optional>

#include "generate/random_source.h"
#include "model/scene.h"

namespace edgecase {

// One to three changes. The scene is what a case file can say, so that all of its coordinates reach
// OpenGL unrounded; none where no such scene was found in a few tries. A function of the scene and
// the numbers alone. Vertices given as clip coordinates stay where they are.
std::optional<Scene> mutated(const Scene& scene, RandomSource& random);

}  // namespace edgecase
