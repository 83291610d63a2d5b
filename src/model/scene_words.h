// SPDX-License-Identifier: MIT
//
// A scene in one line, for tables and summaries: what is drawn and on what. Colours, depths and the
// viewport are left out, so that two scenes may have the same words.
#pragma once

#include <string>

#include "model/scene.h"

namespace edgecase {

// "line (1/2, 1/2) to (7/2, 1/2), 4x4, window": each draw, joined by "; ", then the target's width
// and height in pixels, and "window" if it is no framebuffer object. Coordinates in pixels, y up.
// State is named where it is no default: "width 3/2", "smooth". A draw of many vertices tells its
// first ones and how many there are.
std::string scene_words(const Scene& scene);

// Are both the same in every part, so that every renderer has the same task?
bool same_scene(const Scene& a, const Scene& b);

}  // namespace edgecase
