// SPDX-License-Identifier: MIT
//
// Situation: where on a primitive a pixel lies, in words that many disagreements can share.
//
// What no catalogued alternative explains is sorted by its geometry: all first pixels of vertical
// lines that start on the lower corner of their diamond belong together, wherever the lines lie.
#pragma once

#include <string>

#include "exact/pixel.h"
#include "model/scene.h"

namespace edgecase {

// The situation of a sample, with the vertices as given; of a line that is not multisampled, of the
// pixel that holds it:
// "line, vertical down, first pixel, start on the lower corner of its diamond",
// "triangle, sample exactly on a left edge", "point of size 1, centre exactly on the top side".
// Vertices that are quotients are taken to the nearest multiple of 2^-16, which the words say.
std::string situation_of(const ScenePrimitive& primitive, Point sample, const Target& target);

}  // namespace edgecase
