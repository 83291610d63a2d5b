// SPDX-License-Identifier: MIT
//
// One table of functions for both APIs, OpenGL core and OpenGL ES, and how they differ where the
// same thing is called otherwise. Functions that the context's API does not have are null.
//
// What OpenGL ES cannot do at all is no subject here: reference/es_limits.h refuses such scenes.
#pragma once

#include <glad/gl.h>

#include "reference/gl_context.h"

namespace edgecase {

// Fills the table; the context must be current. False: it offers no functions.
bool load_functions(GladGLContext& gl, const GlContext& context);

// Is it a table of OpenGL ES?
inline bool is_es(const GladGLContext& gl) {
  return gl.ES_VERSION_2_0 != 0;
}

// Does the version have shader storage blocks, by which fragments are captured? A driver may still
// have none for fragment shaders.
inline bool has_storage_blocks(const GladGLContext& gl) {
  return gl.VERSION_4_3 != 0 || gl.ES_VERSION_3_1 != 0;
}

// glDepthRange, of which OpenGL ES has the form with floats alone.
void set_depth_range(const GladGLContext& gl, float near, float far);

// Draws to and reads from a window-system framebuffer that is bound. Returns the name by which its
// colours can be asked for.
GLenum select_window_buffer(const GladGLContext& gl);

}  // namespace edgecase
