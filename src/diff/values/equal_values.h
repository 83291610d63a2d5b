// SPDX-License-Identifier: MIT
//
// Answers that hold what exact holds, to the bit. Most do where colours are flat, and none of their
// values need be judged.
#pragma once

#include "model/rendering.h"
#include "model/scene.h"
#include "rules/choices.h"

namespace edgecase {

// Is exact drawn by OpenGL's own choices, and does the answer tell of fragments and of the target
// all that exact does, bit by bit? Then every value is correct, and so permitted. Said only of what
// is drawn at one go with one sample each, without textures, fragment operations and polygon
// offset, and of answers without details: elsewhere false, which says nothing.
bool has_exact_values(const Scene& scene, const ResolvedPolicy& policy, const Rendering& exact,
                      const Rendering& rendered);

}  // namespace edgecase
