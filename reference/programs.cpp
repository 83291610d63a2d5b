// SPDX-License-Identifier: MIT
#include "reference/programs.h"

#include <optional>
#include <vector>

namespace edgecase {

namespace {

constexpr const char* kVertexShader = R"(#version 430 core
layout(location = 0) in vec4 position;
layout(location = 1) in vec4 color;
layout(location = 2) in int primitive;
flat out vec4 flat_color;
smooth out vec4 smooth_color;
noperspective out vec4 noperspective_color;
flat out int primitive_index;
void main() {
  gl_Position = position;
  flat_color = color;
  smooth_color = color;
  noperspective_color = color;
  primitive_index = primitive;
}
)";

constexpr const char* kColorShader = R"(#version 430 core
flat in vec4 flat_color;
smooth in vec4 smooth_color;
noperspective in vec4 noperspective_color;
layout(location = 0) uniform int interpolation;
layout(location = 0) out vec4 target;
void main() {
  target = interpolation == 0 ? flat_color
                              : (interpolation == 1 ? smooth_color : noperspective_color);
}
)";

constexpr const char* kCountShader = R"(#version 430 core
layout(location = 2) uniform float hit_step;
layout(location = 0) out vec4 target;
void main() {
  target = vec4(hit_step, 0.0, 0.0, 0.0);
}
)";

// The counter runs on beyond the capacity, so that an overflow tells how much room is needed.
constexpr const char* kCaptureShader = R"(#version 430 core
flat in vec4 flat_color;
smooth in vec4 smooth_color;
noperspective in vec4 noperspective_color;
flat in int primitive_index;
layout(location = 0) uniform int interpolation;
layout(location = 1) uniform uint capacity;
layout(location = 0) out vec4 target;
struct Record {
  int x;
  int y;
  int primitive;
  float depth;
  float red;
  float green;
  float blue;
  float alpha;
};
layout(std430, binding = 0) buffer Capture {
  uint count;
  uint unused[7];
  Record records[];
};
void main() {
  vec4 color = interpolation == 0 ? flat_color
                                  : (interpolation == 1 ? smooth_color : noperspective_color);
  uint slot = atomicAdd(count, 1u);
  if (slot < capacity) {
    records[slot] = Record(int(gl_FragCoord.x), int(gl_FragCoord.y), primitive_index,
                           gl_FragCoord.z, color.r, color.g, color.b, color.a);
  }
  target = color;
}
)";

// Compiles one shader; on failure appends the driver's words to `log`.
GlShader compile(const GladGLContext& gl, GLenum stage, const char* source, std::string& log) {
  GlShader shader(gl, gl.CreateShader(stage));
  gl.ShaderSource(shader.name(), 1, &source, nullptr);
  gl.CompileShader(shader.name());
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  std::vector<char> text(4096, '\0');
  gl.GetShaderInfoLog(shader.name(), static_cast<GLsizei>(text.size()) - 1, nullptr, text.data());
  log += text.data();
  return shader;
}

GlProgram link(const GladGLContext& gl, const char* fragment_source, std::string& log) {
  GlProgram program(gl, gl.CreateProgram());
  const GlShader vertex = compile(gl, GL_VERTEX_SHADER, kVertexShader, log);
  const GlShader fragment = compile(gl, GL_FRAGMENT_SHADER, fragment_source, log);
  if (!log.empty()) return program;
  gl.AttachShader(program.name(), vertex.name());
  gl.AttachShader(program.name(), fragment.name());
  gl.LinkProgram(program.name());
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program.name(), GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return program;
  std::vector<char> text(4096, '\0');
  gl.GetProgramInfoLog(program.name(), static_cast<GLsizei>(text.size()) - 1, nullptr, text.data());
  log = text.data();
  if (log.empty()) log = "linking failed";
  return program;
}

}  // namespace

std::variant<Programs, ProgramError> make_programs(const GladGLContext& gl) {
  std::string log;
  Programs programs;
  programs.color = link(gl, kColorShader, log);
  if (log.empty()) programs.count = link(gl, kCountShader, log);
  if (log.empty()) programs.capture = link(gl, kCaptureShader, log);
  if (!log.empty()) return ProgramError{"the driver refuses our shaders: " + log};
  return programs;
}

}  // namespace edgecase
