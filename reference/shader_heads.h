// SPDX-License-Identifier: MIT
//
// The common start of all shaders of a context: the version of its API (GLSL 3.30 to 4.30, GLSL ES
// 3.00 to 3.20), the extensions that ours use, and macros that make one text valid in all of them.
// GLSL before 4.30 and GLSL ES 3.00 number no uniforms: reference/uniform_layouts.h.
//
// In GLSL ES, numbers and samplers are highp: float32, as everywhere else. The macro NOPERSPECTIVE
// is the qualifier or, if there is none, smooth; then no scene may request it. With POINT_SIZE the
// vertex shader writes the size of points, the only way to set it in OpenGL ES.
#pragma once

#include <string>
#include <vector>

#include "reference/gl_objects.h"

namespace edgecase {

std::string head_of_vertices(const GladGLContext& gl);
std::string head_of_fragments(const GladGLContext& gl);

// Heads of fragment shaders with fine and coarse derivatives, to be tried in this order. None for
// OpenGL ES.
std::vector<std::string> fine_heads_of_fragments(const GladGLContext& gl);

}  // namespace edgecase
