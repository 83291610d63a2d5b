// SPDX-License-Identifier: MIT
//
// Does the provoking vertex obey? An entry point that is there need not have an effect, and where
// it has none, flat colours and the numbers of primitives would be another vertex's. So a context
// is asked by drawing.
#pragma once

#include "model/rendering.h"
#include "model/scene.h"

namespace edgecase {

// One line or triangle (`primitive` is lines or triangles), each vertex in a colour of its own.
Scene provoking_scene(Primitive primitive, ProvokingVertex which);

// Has every fragment of that scene the colour of the vertex that provokes, and is there one?
bool obeys(const Rendering& rendering, const Scene& scene);

}  // namespace edgecase
