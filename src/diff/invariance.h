// SPDX-License-Identifier: MIT
//
// Invariance: laws between two answers of one renderer, for which exact is not needed and nothing
// is tolerated. What is drawn otherwise in an image of a scene is a variance.
#pragma once

#include <vector>

#include "diff/scene_images.h"
#include "model/rendering.h"
#include "model/scene.h"

namespace edgecase {

// Appends where a drawing of the image differs from one of what it is an image of: the first of
// them, at most 64. Values that a renderer does not report are the same.
void find_variances(const SceneImage& image, const Rendering& first, const Rendering& second,
                    std::vector<Variance>& variances);

// The same of two primitives of one drawing, of which one is the other moved by whole pixels
// (14.2): of a draw without scissor, where `images_of` would move them, in a target whose sides are
// powers of 2 and at most 128 pixels.
void find_variances_of_primitives(const Scene& scene, const Rendering& drawn,
                                  std::vector<Variance>& variances);

}  // namespace edgecase
