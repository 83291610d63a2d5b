// SPDX-License-Identifier: MIT
//
// Numbers of uniforms for GLSL that has none.
//
// Our shaders number their uniforms, "layout(location = 3) uniform float lookup_value;", and the
// texture units of their images, "layout(binding = 0) uniform sampler2D image;", as GLSL 4.30 and
// GLSL ES 3.10 have it. For earlier versions the layouts are taken out of the text, and what they
// say is done after the program is linked.
#pragma once

#include <string>
#include <vector>

#include "reference/gl_objects.h"

namespace edgecase {

struct UniformLayout {
  std::string name;
  GLint number = 0;         // location or texture unit
  bool is_binding = false;  // true: texture unit
};

// Takes the layouts of uniforms out of a shader's text, and appends them to the list.
void take_uniform_layouts(std::string& source, std::vector<UniformLayout>& layouts);

// Gives a linked program the locations and units of these layouts. Changes the current program.
void apply_uniform_layouts(const GladGLContext& gl, const std::vector<UniformLayout>& layouts,
                           GlProgram& program);

}  // namespace edgecase
