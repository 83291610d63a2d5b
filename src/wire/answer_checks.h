// SPDX-License-Identifier: MIT
//
// What must hold of a rendering that came as bytes before anybody looks at it: the limits within
// which answer_line.h reads a line. For src/wire alone; throws a Refusal.
#pragma once

#include "model/rendering.h"
#include "model/scene.h"

namespace edgecase {

// Does a fragment's detail have any of what details tell?
bool tells_something(const FragmentDetail& detail);

// Sizes of planes, ranges of numbers, places of fragments, details that were asked for, and hit
// counts that agree with fragments; of a supersampled scene, of each pass.
void check_rendering(const Rendering& rendering, const Scene& scene);

// The hit counts alone.
void check_hits(const Rendering& rendering, const Scene& scene);

}  // namespace edgecase
