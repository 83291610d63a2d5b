// SPDX-License-Identifier: MIT
//
// The GL state of fragment operations, facing, polygon offset and depth range, of scenes that use
// any of it. It is set after set_state, for each draw, and put back after each pass: scenes without
// it are drawn by the very calls as if there were none.
#pragma once

#include <glad/gl.h>

#include "model/scene.h"

namespace edgecase {

// What a pass over a scene is to find out.
enum class PassKind {
  pixels,   // what the scene shows: everything as it says
  hits,     // what passes its tests: blending adds up instead, and nothing is masked
  capture,  // what is rasterized: every fragment passes every test, and changes no buffer
};

// Does the scene need any of this state?
bool uses_fragment_state(const Scene& scene);

// The state of a draw in such a scene. Hits are blended by whoever counts them.
void set_fragment_state(const GladGLContext& gl, const Scene& scene, const Draw& draw,
                        PassKind kind);

// Puts all of it back to what a context begins with.
void reset_fragment_state(const GladGLContext& gl);

}  // namespace edgecase
