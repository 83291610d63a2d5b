// SPDX-License-Identifier: MIT
//
// Invariance: laws between two answers of one renderer, for which exact is not needed and nothing
// is tolerated (GL 4.6 core, 14.2 and appendix A; ruling 67).
//
// An image of a scene is another scene of which a law says how it is drawn: at another place, with
// other masks, or once more. What is drawn otherwise is a variance.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/rendering.h"
#include "model/scene.h"

namespace edgecase {

struct SceneImage {
  std::string text;            // how it differs: "is moved by 47 pixels to the right and 45 up"
  std::optional<Scene> first;  // what it is an image of; nothing: the scene itself
  Scene second;
  // How far pixels of `second` lie right of and above those of `first`.
  int right = 0;
  int up = 0;
  // Whether colours, depths and the target, too, are to be the same, and not only fragments.
  bool has_values = false;
  bool has_pixels = false;
};

// The images of a scene about which the specification speaks:
//
//   moved     by whole pixels (14.2), for scenes of one sample whose primitives lie in the target
//             and are not divided by w.
//             Both scenes have a target of 64 or 128 pixels, whose window coordinates float32 holds
//             exactly, so that no rounding differs.
//   masked    with all colours masked and another clear colour (A.3, rule 2)
//   repeated  drawn once more (A.3, rule 1)
std::vector<SceneImage> images_of(const Scene& scene);

// Appends where a drawing of the image differs from one of what it is an image of: the first of
// them, at most 64. Values that a renderer does not report are the same.
void find_variances(const SceneImage& image, const Rendering& first, const Rendering& second,
                    std::vector<Variance>& variances);

}  // namespace edgecase
