// SPDX-License-Identifier: MIT
//
// The situation of a difference: where a sample lies relative to its primitive, in words that many
// disagreements can share.
#pragma once

#include <string>

#include "exact/fixed.h"
#include "model/scene.h"

namespace edgecase {

// Differences that no catalogued alternative explains are sorted by geometry: all first pixels of
// vertical lines that start on the lower corner of their diamond belong together, wherever the
// lines lie.
//
// Uses the vertices as given and, for a line that is not multisampled, the pixel:
// "line, vertical down, first pixel, start on the lower corner of its diamond",
// "triangle, sample exactly on a left edge", "point of size 1, centre exactly on the top side".
// Vertices that are quotients are rounded to a multiple of 2^-16, which the text says.
std::string situation_of(const ScenePrimitive& primitive, Point sample, const Target& target);

}  // namespace edgecase
