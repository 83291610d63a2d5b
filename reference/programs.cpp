// SPDX-License-Identifier: MIT
#include "reference/programs.h"

#include <vector>

#include "reference/gl_api.h"
#include "reference/shader_heads.h"
#include "reference/shaders.h"
#include "reference/uniform_layouts.h"

namespace edgecase {

namespace {

using namespace shaders;

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

// The text between the version and a fragment shader that looks up.
std::string lookup_head(LookupForm form, bool query) {
  if (form.dimensions == 0) return kUntextured;
  std::string head = form.dimensions == 1 ? kOneDimensional : kTwoDimensional;
  if (query && form.kind == LookupKind::implicit) head += kQuery;
  return head + "#define LOOKUP " + lookup_of(form.kind) + "\n" + kImage + kTextured;
}

// Compiles one shader; on failure appends the driver's message to `log`.
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

// Sources start with a version. Does nothing if the log has an earlier failure.
GlProgram link_sources(const GladGLContext& gl, std::string vertex_source,
                       std::string fragment_source, std::string& log) {
  if (!log.empty()) return {};
  std::vector<UniformLayout> layouts;
  if (!has_uniform_layouts(gl))
    for (std::string* source : {&vertex_source, &fragment_source})
      take_uniform_layouts(*source, layouts);
  GlProgram program(gl, gl.CreateProgram());
  const GlShader vertex = compile(gl, GL_VERTEX_SHADER, vertex_source, log);
  const GlShader fragment = compile(gl, GL_FRAGMENT_SHADER, fragment_source, log);
  if (!log.empty()) return program;
  gl.AttachShader(program.name(), vertex.name());
  gl.AttachShader(program.name(), fragment.name());
  gl.LinkProgram(program.name());
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program.name(), GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) {
    if (!has_uniform_layouts(gl)) apply_uniform_layouts(gl, layouts, program);
    return program;
  }
  std::vector<char> text(4096, '\0');
  gl.GetProgramInfoLog(program.name(), static_cast<GLsizei>(text.size()) - 1, nullptr, text.data());
  log = text.data();
  if (log.empty()) log = "linking failed";
  return program;
}

// `at`: where both shaders evaluate interpolated attributes.
GlProgram link(const GladGLContext& gl, const std::string& at, const std::string& version,
               const std::string& fragment, std::string& log) {
  return link_sources(gl, head_of_vertices(gl) + at + kVertexShader, version + at + fragment, log);
}

// The programs of a form; `head` is the start of its shaders after the version.
Programs link_form(const GladGLContext& gl, const std::string& at, const std::string& head,
                   std::string& log) {
  Programs programs;
  const std::string version = head_of_fragments(gl);
  const std::string color = head + kInputs + kColorShader;
  const std::string capture =
      (has_storage_blocks(gl) ? kStorage : kWords) + head + kInputs + kCaptureShader;
  programs.color = link(gl, at, version, color, log);
  programs.timed = link(gl, at, version, kTimed + color, log);
  programs.capture = link(gl, at, version, capture, log);
  if (!log.empty()) return programs;
  // Details include fine and coarse derivatives if the driver compiles them.
  const std::string details = kDetails + capture;
  for (const std::string& fine : fine_heads_of_fragments(gl)) {
    std::string refusal;
    programs.details = link(gl, at, fine, details, refusal);
    programs.fine_and_coarse = refusal.empty();
    if (programs.fine_and_coarse) return programs;
  }
  programs.details = link(gl, at, version, details, log);
  return programs;
}

const char* head_of(AttributeLocation location) {
  switch (location) {
    case AttributeLocation::center:
      return kAtCenter;
    case AttributeLocation::centroid:
      return kAtCentroid;
    case AttributeLocation::sample:
      return kAtSample;
  }
  return kAtCenter;
}

std::string refusal(const std::string& log) {
  return "the driver refuses our shaders: " + log;
}

}  // namespace

std::variant<Programs, ProgramError> make_programs(const GladGLContext& gl) {
  std::string log;
  Programs programs = link_form(gl, kAtCenter, "", log);
  programs.count =
      link(gl, kAtCenter, head_of_fragments(gl), std::string(kInputs) + kCountShader, log);
  if (!log.empty()) return ProgramError{refusal(log)};
  return programs;
}

std::variant<Programs, ProgramError> make_sampled_programs(const GladGLContext& gl,
                                                           AttributeLocation location) {
  const std::string at = head_of(location);
  std::string log;
  Programs programs = link_form(gl, at, kSamples, log);
  programs.count = link(gl, at, head_of_fragments(gl), std::string(kInputs) + kCountShader, log);
  if (!log.empty()) return ProgramError{refusal(log)};
  return programs;
}

bool can_query_level_of_detail(const GladGLContext& gl) {
  std::string log;
  const std::string main = "void main() { gl_FragDepth = queried(gl_FragCoord).y; }\n";
  link_sources(gl, head_of_vertices(gl) + kEverywhere,
               head_of_fragments(gl) + lookup_head({2, LookupKind::implicit}, true) + main, log);
  return log.empty();
}

std::variant<Programs, ProgramError> make_texture_programs(const GladGLContext& gl, LookupForm form,
                                                           bool query) {
  std::string log;
  Programs programs = link_form(gl, kAtCenter, lookup_head(form, query), log);
  if (!log.empty()) return ProgramError{refusal(log)};
  return programs;
}

std::variant<GlProgram, ProgramError> make_program(const GladGLContext& gl,
                                                   const std::string& vertex,
                                                   const std::string& fragment) {
  std::string log;
  GlProgram program =
      link_sources(gl, head_of_vertices(gl) + vertex, head_of_fragments(gl) + fragment, log);
  if (!log.empty()) return ProgramError{refusal(log)};
  return program;
}

}  // namespace edgecase
