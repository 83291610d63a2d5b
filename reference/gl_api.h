// SPDX-License-Identifier: MIT
//
// One table of functions for both APIs, OpenGL core and OpenGL ES, and their differences for the
// same operation. Functions that the context's API lacks are null.
//
// reference/es_limits.h refuses scenes that OpenGL ES cannot draw at all.
#pragma once

#include <glad/gl.h>

#include "reference/gl_context.h"

namespace edgecase {

// Fills the table; the context must be current. False if it offers no functions.
bool load_functions(GladGLContext& gl, const GlContext& context);

// Whether the table is of OpenGL ES.
inline bool is_es(const GladGLContext& gl) {
  return gl.ES_VERSION_2_0 != 0;
}

// Whether fragment shaders have storage blocks, to which they write what they tell. Versions before
// OpenGL 4.3 and OpenGL ES 3.1 have none, and later ones need not have them for this stage.
bool has_storage_blocks(const GladGLContext& gl);

// Whether shaders number their uniforms and texture units: OpenGL 4.3, OpenGL ES 3.1.
inline bool has_uniform_layouts(const GladGLContext& gl) {
  return gl.VERSION_4_3 != 0 || gl.ES_VERSION_3_1 != 0;
}

// glDepthRange, which in OpenGL ES exists only with floats.
void set_depth_range(const GladGLContext& gl, float near, float far);

// Draws to and reads from the bound window-system framebuffer. Returns the name for queries about
// its colours.
GLenum select_window_buffer(const GladGLContext& gl);

}  // namespace edgecase
