// SPDX-License-Identifier: MIT
//
// The fixed-function state of a draw, set in one place, and the errors of the GL.
#pragma once

#include <glad/gl.h>

#include "model/scene.h"

namespace edgecase {

GLenum mode_of(Primitive primitive);

// The whole state of a draw that has no fragment operations, but for blending and uniforms, which
// belong to the pass. What else scenes have is in reference/fragment_state.h. The program that
// draws must be the one in use: of OpenGL ES, the size of points is a uniform.
void set_state(const GladGLContext& gl, const Scene& scene, const Draw& draw);

// How a draw to a target of this many samples uses them. Set after set_state, and set back to the
// default, which is what a context begins with, before anything else is drawn: drivers without
// multisampled targets do not have all of this state, and need not.
void set_multisampling(const GladGLContext& gl, const Multisampling& multisampling, int samples);

// Clears the colours of a framebuffer, by its name, and leaves it bound.
void clear(const GladGLContext& gl, GLuint framebuffer, const Color& color);

// The first error since the last call, or GL_NO_ERROR. A lost context reports its loss for ever.
GLenum take_error(const GladGLContext& gl);

const char* name_of_error(GLenum error);

}  // namespace edgecase
