// SPDX-License-Identifier: MIT
//
// The fixed-function state of a draw, set in one place, and the errors of the GL.
#pragma once

#include <glad/gl.h>

#include "model/scene.h"

namespace edgecase {

GLenum mode_of(Primitive primitive);

// The whole state of a draw, but for blending and uniforms, which belong to the pass.
void set_state(const GladGLContext& gl, const Scene& scene, const Draw& draw);

// Clears a framebuffer, by its name, and leaves it bound; its depth buffer, where it has one, to 1.
void clear(const GladGLContext& gl, GLuint framebuffer, const Color& color, bool has_depth);

// The first error since the last call, or GL_NO_ERROR. A lost context reports its loss for ever.
GLenum take_error(const GladGLContext& gl);

const char* name_of_error(GLenum error);

}  // namespace edgecase
