// SPDX-License-Identifier: MIT
//
// Sets the fixed-function state of a draw in one place, and reports the GL's errors.
#pragma once

#include <glad/gl.h>

#include "model/scene.h"
#include "reference/gl_objects.h"

namespace edgecase {

GLenum mode_of(Primitive primitive);

// Sets the whole state of a draw without fragment operations, except blending and uniforms, which
// belong to the pass. reference/fragment_state.h has the rest. `program` must be in use already: in
// OpenGL ES, the size of points is a uniform.
void set_state(const GladGLContext& gl, const Scene& scene, const Draw& draw,
               const GlProgram& program);

// Sets how a draw uses the samples of a target. Call it after set_state, and restore the default, a
// context's initial state, before anything else is drawn: drivers without multisampled targets need
// not have all of this state.
void set_multisampling(const GladGLContext& gl, const Multisampling& multisampling, int samples);

// Clears the colours of a framebuffer, by name, and leaves it bound.
void clear(const GladGLContext& gl, GLuint framebuffer, const Color& color);

// The first error since the last call, or GL_NO_ERROR. A lost context reports its loss for ever.
GLenum take_error(const GladGLContext& gl);

const char* name_of_error(GLenum error);

// Does a draw look up a texture?
bool is_textured(const Scene& scene);

}  // namespace edgecase
