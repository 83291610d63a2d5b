// SPDX-License-Identifier: MIT
//
// What all shaders of a context begin with: the version of its API, the extensions that ours use,
// and what makes one text good for GLSL and for GLSL ES.
//
// Of GLSL ES, numbers and samplers are highp: float32, as everywhere else. The macro NOPERSPECTIVE
// is the qualifier, or where there is none, smooth: then no scene may ask for it. POINT_SIZE has
// the vertex shader write the size of points, which OpenGL ES takes from nowhere else.
#pragma once

#include <string>
#include <vector>

#include "reference/gl_objects.h"

namespace edgecase {

std::string head_of_vertices(const GladGLContext& gl);
std::string head_of_fragments(const GladGLContext& gl);

// Heads of fragment shaders that take fine and coarse derivatives, to be tried in this order. None
// of OpenGL ES.
std::vector<std::string> fine_heads_of_fragments(const GladGLContext& gl);

}  // namespace edgecase
