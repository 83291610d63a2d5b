// SPDX-License-Identifier: MIT
//
// Tests whether setting the provoking vertex has an effect. The function may exist without one, and
// then flat colours and primitive numbers would be those of another vertex, so it is tested by
// drawing.
#pragma once

#include "model/rendering.h"
#include "model/scene.h"

namespace edgecase {

// One line or triangle (`primitive` is lines or triangles), with a distinct colour at each vertex.
Scene provoking_scene(Primitive primitive, ProvokingVertex which);

// Whether there are fragments, all with the colour of the vertex that provokes.
bool obeys(const Rendering& rendering, const Scene& scene);

}  // namespace edgecase
