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

// Heads of the fragment shaders below: the version, what is switched on, and for textured scenes
// how colours are looked up. One function serves pixels and capture, so that both have the same
// colours.
constexpr const char* kVersion = "#version 430 core\n";
constexpr const char* kQuery = "#define QUERY\n";

constexpr const char* kOneDimensional =
    "#define SAMPLER sampler1D\n#define ST x\n#define DX x\n#define DY z\n";
constexpr const char* kTwoDimensional =
    "#define SAMPLER sampler2D\n#define ST xy\n#define DX xy\n#define DY zw\n";
constexpr const char* kImage = R"(
layout(location = 3) uniform float lookup_value;
layout(location = 4) uniform vec4 gradients;
layout(binding = 0) uniform SAMPLER image;
)";
constexpr const char* kUntextured = R"(#define TEXTURES
vec4 looked_up(vec4 color) { return color; }
vec2 queried(vec4 color) { return vec2(0.0); }
)";
constexpr const char* kTextured = R"(#define TEXTURES
vec4 looked_up(vec4 color) { return LOOKUP; }
#ifdef QUERY
vec2 queried(vec4 color) { return textureQueryLod(image, color.ST); }
#else
vec2 queried(vec4 color) { return vec2(0.0); }
#endif
)";

constexpr const char* kColorShader = R"(
flat in vec4 flat_color;
smooth in vec4 smooth_color;
noperspective in vec4 noperspective_color;
layout(location = 0) uniform int interpolation;
layout(location = 0) out vec4 target;
void main() {
  vec4 color = interpolation == 0 ? flat_color
                                  : (interpolation == 1 ? smooth_color : noperspective_color);
#ifdef TEXTURES
  color = looked_up(color);
#endif
  target = color;
}
)";

constexpr const char* kCountShader = R"(
layout(location = 2) uniform float hit_step;
layout(location = 0) out vec4 target;
void main() {
  target = vec4(hit_step, 0.0, 0.0, 0.0);
}
)";

// Without a version, and in two forms: DETAILS adds what reference/capture.h calls details, and
// FINE_AND_COARSE the derivatives that not every GLSL has. The counter runs on beyond the capacity,
// so that an overflow tells how much room is needed.
constexpr const char* kCaptureShader = R"(
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
#ifdef DETAILS
  vec4 coordinates;
  vec4 dx;
  vec4 dy;
  vec4 dx_fine;
  vec4 dy_fine;
  vec4 dx_coarse;
  vec4 dy_coarse;
#ifdef TEXTURES
  vec2 texture_coordinates;
  vec2 level_of_detail;
#endif
#endif
};
layout(std430, binding = 0) buffer Capture {
  uint count;
  uint unused[7];
  Record records[];
};
void main() {
  vec4 color = interpolation == 0 ? flat_color
                                  : (interpolation == 1 ? smooth_color : noperspective_color);
#ifdef DETAILS
  vec4 dx = dFdx(color);
  vec4 dy = dFdy(color);
#ifdef FINE_AND_COARSE
  vec4 dx_fine = dFdxFine(color);
  vec4 dy_fine = dFdyFine(color);
  vec4 dx_coarse = dFdxCoarse(color);
  vec4 dy_coarse = dFdyCoarse(color);
#else
  vec4 dx_fine = vec4(0.0);
  vec4 dy_fine = vec4(0.0);
  vec4 dx_coarse = vec4(0.0);
  vec4 dy_coarse = vec4(0.0);
#endif
#ifdef TEXTURES
  vec2 texture_coordinates = color.xy;
  vec2 level_of_detail = queried(color);
#endif
#endif
#ifdef TEXTURES
  color = looked_up(color);
#endif
  uint slot = atomicAdd(count, 1u);
  if (slot < capacity) {
    records[slot].x = int(gl_FragCoord.x);
    records[slot].y = int(gl_FragCoord.y);
    records[slot].primitive = primitive_index;
    records[slot].depth = gl_FragCoord.z;
    records[slot].red = color.r;
    records[slot].green = color.g;
    records[slot].blue = color.b;
    records[slot].alpha = color.a;
#ifdef DETAILS
    records[slot].coordinates = gl_FragCoord;
    records[slot].dx = dx;
    records[slot].dy = dy;
    records[slot].dx_fine = dx_fine;
    records[slot].dy_fine = dy_fine;
    records[slot].dx_coarse = dx_coarse;
    records[slot].dy_coarse = dy_coarse;
#ifdef TEXTURES
    records[slot].texture_coordinates = texture_coordinates;
    records[slot].level_of_detail = level_of_detail;
#endif
#endif
  }
  target = color;
}
)";

constexpr const char* kDetails = "#define DETAILS\n";
// Fine and coarse derivatives are part of GLSL 4.50, and an extension before.
constexpr const char* kFineVersions[] = {
    "#version 450 core\n#define FINE_AND_COARSE\n",
    "#version 430 core\n#extension GL_ARB_derivative_control : require\n"
    "#define FINE_AND_COARSE\n"};

const char* lookup_of(LookupKind kind) {
  switch (kind) {
    case LookupKind::implicit:
      return "texture(image, color.ST)";
    case LookupKind::bias:
      return "texture(image, color.ST, lookup_value)";
    case LookupKind::lod:
      return "textureLod(image, color.ST, lookup_value)";
    case LookupKind::gradients:
      return "textureGrad(image, color.ST, gradients.DX, gradients.DY)";
  }
  return "";
}

// What comes between the version and a fragment shader that looks up.
std::string lookup_head(LookupForm form, bool query) {
  if (form.dimensions == 0) return kUntextured;
  std::string head = form.dimensions == 1 ? kOneDimensional : kTwoDimensional;
  if (query && form.kind == LookupKind::implicit) head += kQuery;
  return head + "#define LOOKUP " + lookup_of(form.kind) + "\n" + kImage + kTextured;
}

// Compiles one shader; on failure appends the driver's words to `log`.
GlShader compile(const GladGLContext& gl, GLenum stage, const std::string& source,
                 std::string& log) {
  GlShader shader(gl, gl.CreateShader(stage));
  const char* const text_of_source = source.c_str();
  gl.ShaderSource(shader.name(), 1, &text_of_source, nullptr);
  gl.CompileShader(shader.name());
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  std::vector<char> text(4096, '\0');
  gl.GetShaderInfoLog(shader.name(), static_cast<GLsizei>(text.size()) - 1, nullptr, text.data());
  log += text.data();
  return shader;
}

GlProgram link(const GladGLContext& gl, const std::string& fragment_source, std::string& log) {
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

// The capture program with details, with fine and coarse derivatives where the driver takes them,
// by trying. `head` comes after the version.
GlProgram link_details(const GladGLContext& gl, const std::string& head, bool& fine_and_coarse,
                       std::string& log) {
  const std::string rest = kDetails + head + kCaptureShader;
  for (const char* version : kFineVersions) {
    std::string refusal;
    GlProgram program = link(gl, version + rest, refusal);
    fine_and_coarse = refusal.empty();
    if (fine_and_coarse) return program;
  }
  return link(gl, kVersion + rest, log);
}

std::string refusal(const std::string& log) {
  return "the driver refuses our shaders: " + log;
}

}  // namespace

std::variant<Programs, ProgramError> make_programs(const GladGLContext& gl) {
  const std::string version = kVersion;
  std::string log;
  Programs programs;
  programs.color = link(gl, version + kColorShader, log);
  if (log.empty()) programs.count = link(gl, version + kCountShader, log);
  if (log.empty()) programs.capture = link(gl, version + kCaptureShader, log);
  if (log.empty()) programs.details = link_details(gl, "", programs.fine_and_coarse, log);
  if (!log.empty()) return ProgramError{refusal(log)};
  return programs;
}

bool can_query_level_of_detail(const GladGLContext& gl) {
  std::string log;
  const std::string main = "void main() { gl_FragDepth = queried(gl_FragCoord).y; }\n";
  compile(gl, GL_FRAGMENT_SHADER, kVersion + lookup_head({2, LookupKind::implicit}, true) + main,
          log);
  return log.empty();
}

std::variant<Programs, ProgramError> make_texture_programs(const GladGLContext& gl, LookupForm form,
                                                           bool query) {
  const std::string head = lookup_head(form, query);
  std::string log;
  Programs programs;
  programs.color = link(gl, kVersion + head + kColorShader, log);
  if (log.empty()) programs.capture = link(gl, kVersion + head + kCaptureShader, log);
  if (log.empty()) programs.details = link_details(gl, head, programs.fine_and_coarse, log);
  if (!log.empty()) return ProgramError{refusal(log)};
  return programs;
}

}  // namespace edgecase
