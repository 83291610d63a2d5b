// SPDX-License-Identifier: MIT
//
// Roots: mistakes of a program that make many checks fail at once, found in one picture.
//
// The picture has three primitives near its bottom, red on cyan. The pixels that are looked at lie
// far from every edge, so that any rule of rasterization gives the same.
#pragma once

#include <vector>

#include "tools/edgecase/protocol/pictures.h"

namespace edgecase {

// The scene to draw, of points, lines or triangles. Of the triangles, the middle one is clockwise.
Scene root_scene(Primitive primitive);

// The roots that show in a rendering of root_scene(primitive), each told once.
std::vector<Fault> roots_of(Primitive primitive, const Rendering& rendering);

}  // namespace edgecase
