// SPDX-License-Identifier: MIT
//
// The GL state of fragment operations, facing, polygon offset and depth range, for scenes that use
// any of it. It is set after set_state, for each draw, and reset after each pass, so scenes without
// it are drawn by the same calls as if it did not exist.
#pragma once

#include <glad/gl.h>

#include "model/scene.h"

namespace edgecase {

// The purpose of a pass over a scene.
enum class PassKind {
  pixels,   // what the scene shows: everything as specified
  hits,     // what passes its tests: blending adds up instead, and nothing is masked
  capture,  // what is rasterized: every fragment passes every test, and changes no buffer
};

// Whether the scene needs any of this state.
bool uses_fragment_state(const Scene& scene);

// Sets the state of a draw in such a scene. The blending of hits is set by their counter.
void set_fragment_state(const GladGLContext& gl, const Scene& scene, const Draw& draw,
                        PassKind kind);

// Restores the state of a draw without any.
void reset_fragment_state(const GladGLContext& gl);

}  // namespace edgecase
