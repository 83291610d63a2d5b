// SPDX-License-Identifier: MIT
#include "reference/draw_state.h"

#include <algorithm>

#include "reference/gl_api.h"
#include "reference/programs.h"

namespace edgecase {

namespace {

void set_scissor(const GladGLContext& gl, const Draw& draw) {
  if (!draw.scissor) {
    gl.Disable(GL_SCISSOR_TEST);
    return;
  }
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(draw.scissor->x, draw.scissor->y, draw.scissor->width, draw.scissor->height);
}

// Every fragment passes and is written; if the test is disabled, nothing is written either.
void set_depth(const GladGLContext& gl, bool has_depth) {
  gl.DepthFunc(GL_ALWAYS);
  gl.DepthMask(GL_TRUE);
  if (has_depth)
    gl.Enable(GL_DEPTH_TEST);
  else
    gl.Disable(GL_DEPTH_TEST);
}

// State that OpenGL ES lacks. There it always has these values, except for the size of points,
// which a shader writes, and the provoking vertex, which is the last one.
void set_desktop_state(const GladGLContext& gl, const Draw& draw) {
  constexpr GLenum kSwitchedOff[] = {
      GL_LINE_SMOOTH,         GL_POLYGON_SMOOTH,    GL_POLYGON_OFFSET_POINT,
      GL_POLYGON_OFFSET_LINE, GL_COLOR_LOGIC_OP,    GL_FRAMEBUFFER_SRGB,
      GL_DEPTH_CLAMP,         GL_PRIMITIVE_RESTART, GL_PROGRAM_POINT_SIZE};
  for (GLenum off : kSwitchedOff) gl.Disable(off);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  gl.PointSize(static_cast<float>(draw.point_size.to_double()));
  gl.ProvokingVertex(draw.provoking_vertex == ProvokingVertex::first ? GL_FIRST_VERTEX_CONVENTION
                                                                     : GL_LAST_VERTEX_CONVENTION);
}

}  // namespace

GLenum mode_of(Primitive primitive) {
  switch (primitive) {
    case Primitive::points:
      return GL_POINTS;
    case Primitive::lines:
      return GL_LINES;
    case Primitive::line_strip:
      return GL_LINE_STRIP;
    case Primitive::line_loop:
      return GL_LINE_LOOP;
    case Primitive::triangles:
      return GL_TRIANGLES;
    case Primitive::triangle_strip:
      return GL_TRIANGLE_STRIP;
    case Primitive::triangle_fan:
      return GL_TRIANGLE_FAN;
  }
  return GL_POINTS;
}

void set_state(const GladGLContext& gl, const Scene& scene, const Draw& draw,
               const GlProgram& program) {
  // GL_RASTERIZER_DISCARD is omitted: nothing here enables it, and a driver without transform
  // feedback raises an error (zink over SwiftShader).
  constexpr GLenum kSwitchedOff[] = {GL_CULL_FACE,       GL_STENCIL_TEST,
                                     GL_DITHER,          GL_POLYGON_OFFSET_FILL,
                                     GL_SAMPLE_COVERAGE, GL_SAMPLE_ALPHA_TO_COVERAGE};
  for (GLenum off : kSwitchedOff) gl.Disable(off);
  // OpenGL ES 3.0 has no masks of samples.
  if (gl.SampleMaski != nullptr) gl.Disable(GL_SAMPLE_MASK);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (is_es(gl))
    gl.Uniform1f(program.location(kPointSizeUniform),
                 static_cast<float>(draw.point_size.to_double()));
  else
    set_desktop_state(gl, draw);
  gl.LineWidth(static_cast<float>(draw.line_width.to_double()));
  set_depth_range(gl, 0, 1);
  gl.Viewport(scene.viewport.x, scene.viewport.y, scene.viewport.width, scene.viewport.height);
  set_depth(gl, scene.target.depth != DepthFormat::none);
  set_scissor(gl, draw);
}

void set_multisampling(const GladGLContext& gl, const Multisampling& multisampling, int samples) {
  const std::uint32_t all = (std::uint32_t{1} << samples) - 1;
  const auto enable = [&](GLenum name, bool on) { on ? gl.Enable(name) : gl.Disable(name); };
  // OpenGL ES always rasterizes sample by sample.
  if (!is_es(gl)) enable(GL_MULTISAMPLE, multisampling.enabled);
  enable(GL_SAMPLE_ALPHA_TO_COVERAGE, multisampling.alpha_to_coverage);
  enable(GL_SAMPLE_MASK, (multisampling.mask & all) != all);
  gl.SampleMaski(0, multisampling.mask);
  if (gl.MinSampleShading == nullptr) return;
  enable(GL_SAMPLE_SHADING, multisampling.min_sample_shading.has_value());
  gl.MinSampleShading(multisampling.min_sample_shading.value_or(0));
}

void clear(const GladGLContext& gl, GLuint framebuffer, const Color& color) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_DITHER);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.ClearBufferfv(GL_COLOR, 0, color.data());
}

GLenum take_error(const GladGLContext& gl) {
  const GLenum first = gl.GetError();
  for (GLenum next = first; next != GL_NO_ERROR && next != GL_CONTEXT_LOST;) next = gl.GetError();
  return first;
}

const char* name_of_error(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    case GL_CONTEXT_LOST:
      return "GL_CONTEXT_LOST";
    default:
      return "an unknown GL error";
  }
}

bool is_textured(const Scene& scene) {
  return std::any_of(scene.draws.begin(), scene.draws.end(),
                     [](const Draw& draw) { return draw.texture.has_value(); });
}

}  // namespace edgecase
