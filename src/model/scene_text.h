// SPDX-License-Identifier: MIT
//
// A scene in one line of text, for tables and summaries: what is drawn on what. Colours, depths and
// the viewport are left out, so different scenes may have the same text.
#pragma once

#include <string>

#include "model/scene.h"

namespace edgecase {

// "line (1/2, 1/2) to (7/2, 1/2), 4x4, window": each draw, joined by "; ", then the target's width
// and height in pixels, and "window" if it is no framebuffer object. Coordinates in pixels, y up.
// State is named if it is not the default: "width 3/2", "smooth". For many vertices, only the first
// ones and the number of others are listed.
std::string scene_text(const Scene& scene);

// Whether both are equal in every part, so that every renderer has the same task.
bool same_scene(const Scene& a, const Scene& b);

}  // namespace edgecase
