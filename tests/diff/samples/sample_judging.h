// SPDX-License-Identifier: MIT
//
// Judging renderers of multisampled scenes: each is the exact side under a policy of its own.
#pragma once

#include <string>

#include "model/rendering.h"
#include "model/scene.h"
#include "tests/support/judging.h"

namespace edgecase {

// Triangles with smooth colours that cover pixels in part, in all directions.
Scene partly_covered(int samples = 4);

// What a renderer makes of the scene that has one rule otherwise, but reports the positions that
// exact has.
Rendering rendered_with(const Scene& scene, const std::string& rule,
                        const std::string& alternative);

}  // namespace edgecase
