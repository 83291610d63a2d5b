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

// Does a detail tell what the request does not ask for, or what there is of textured draws alone?
void check_detail(const FragmentDetail& detail, Details asked, bool is_textured);

// Sizes of planes and ranges of numbers; of a supersampled scene, of each pass. Fragments are
// checked where they are read (wire/sent_fragments.h).
void check_rendering(const Rendering& rendering, const Scene& scene);

// Hit counts that agree with fragments, which lie within the rendering.
void check_hits(const Rendering& rendering, const Scene& scene);

}  // namespace edgecase
