// SPDX-License-Identifier: MIT
#include "reference/scene_renderer.h"

#include <fmt/format.h>

#include <cstddef>

namespace edgecase {

namespace {

struct GpuVertex {
  float clip[4];
  float color[4];
  std::int32_t primitive;
};

// The clip coordinate that the viewport transform takes to window coordinate `window`.
float to_clip(Fixed window, int origin, int size) {
  const double half = size / 2.0;
  return static_cast<float>((window.to_double() - (origin + half)) / half);
}

std::vector<GpuVertex> gpu_vertices(const Scene& scene) {
  std::vector<GpuVertex> result;
  const Viewport& viewport = scene.viewport;
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    const int count = vertices_per_primitive(primitive.state->primitive);
    for (int i = 0; i < count; ++i) {
      const Vertex& vertex = primitive.vertices[i];
      const Color& color = vertex.color;
      result.push_back({{to_clip(vertex.position.x, viewport.x, viewport.width),
                         to_clip(vertex.position.y, viewport.y, viewport.height),
                         static_cast<float>(vertex.z.to_double()), 1.0f},
                        {color[0], color[1], color[2], color[3]},
                        primitive.index});
    }
  }
  return result;
}

GLenum mode_of(Primitive primitive) {
  switch (primitive) {
    case Primitive::points:
      return GL_POINTS;
    case Primitive::lines:
      return GL_LINES;
    case Primitive::triangles:
      return GL_TRIANGLES;
  }
  return GL_POINTS;
}

// The whole fixed-function state of a draw, but for blending, which belongs to the pass.
void set_state(const GladGLContext& gl, const Scene& scene, const Draw& draw) {
  constexpr GLenum kSwitchedOff[] = {GL_CULL_FACE,
                                     GL_DEPTH_TEST,
                                     GL_STENCIL_TEST,
                                     GL_SCISSOR_TEST,
                                     GL_DITHER,
                                     GL_LINE_SMOOTH,
                                     GL_POLYGON_SMOOTH,
                                     GL_POLYGON_OFFSET_POINT,
                                     GL_POLYGON_OFFSET_LINE,
                                     GL_POLYGON_OFFSET_FILL,
                                     GL_COLOR_LOGIC_OP,
                                     GL_FRAMEBUFFER_SRGB,
                                     GL_DEPTH_CLAMP,
                                     GL_PRIMITIVE_RESTART,
                                     GL_RASTERIZER_DISCARD,
                                     GL_PROGRAM_POINT_SIZE,
                                     GL_SAMPLE_ALPHA_TO_COVERAGE,
                                     GL_SAMPLE_COVERAGE,
                                     GL_SAMPLE_MASK};
  for (GLenum off : kSwitchedOff) gl.Disable(off);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  gl.PointSize(1);
  gl.LineWidth(1);
  gl.DepthRange(0, 1);
  gl.Viewport(scene.viewport.x, scene.viewport.y, scene.viewport.width, scene.viewport.height);
  gl.ProvokingVertex(draw.provoking_vertex == ProvokingVertex::first ? GL_FIRST_VERTEX_CONVENTION
                                                                     : GL_LAST_VERTEX_CONVENTION);
}

void clear(const GladGLContext& gl, const GlFramebuffer& framebuffer, const Color& color) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_DITHER);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.ClearBufferfv(GL_COLOR, 0, color.data());
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

// The first error since the last call, or GL_NO_ERROR. A lost context reports its loss for ever.
GLenum take_error(const GladGLContext& gl) {
  const GLenum first = gl.GetError();
  for (GLenum next = first; next != GL_NO_ERROR && next != GL_CONTEXT_LOST;) next = gl.GetError();
  return first;
}

}  // namespace

SceneRenderer::Objects::Objects(const GladGLContext& gl, Programs made)
    : programs(std::move(made)),
      capture(gl),
      targets(gl),
      vertices(make_buffer(gl)),
      vertex_array(make_vertex_array(gl)) {
  gl.BindVertexArray(vertex_array.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices.name());
  const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
  constexpr GLsizei kStride = sizeof(GpuVertex);
  gl.VertexAttribPointer(kPositionAttribute, 4, GL_FLOAT, GL_FALSE, kStride,
                         offset(offsetof(GpuVertex, clip)));
  gl.VertexAttribPointer(kColorAttribute, 4, GL_FLOAT, GL_FALSE, kStride,
                         offset(offsetof(GpuVertex, color)));
  gl.VertexAttribIPointer(kPrimitiveAttribute, 1, GL_INT, kStride,
                          offset(offsetof(GpuVertex, primitive)));
  for (GLuint attribute : {kPositionAttribute, kColorAttribute, kPrimitiveAttribute})
    gl.EnableVertexAttribArray(attribute);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
}

SceneRenderer::SceneRenderer(const GlContext& context) {
  const auto load = [](void* user, const char* name) {
    return static_cast<const GlContext*>(user)->get_proc(name);
  };
  const int version = gladLoadGLContextUserPtr(&gl_, load, const_cast<GlContext*>(&context));
  if (version == 0) {
    problem_ = "the context offers no OpenGL functions";
    return;
  }
  describe(context);
  GLint storage_blocks = 0;
  if (gl_.VERSION_4_3) gl_.GetIntegerv(GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, &storage_blocks);
  if (storage_blocks == 0) {
    problem_ = fmt::format(
        "capturing fragments needs shader storage blocks (OpenGL 4.3), and "
        "this context is {} without them",
        info_.version);
    return;
  }
  auto programs = make_programs(gl_);
  if (auto* error = std::get_if<ProgramError>(&programs)) {
    problem_ = error->message;
    return;
  }
  objects_.emplace(gl_, std::move(std::get<Programs>(programs)));
  info_.traits["capture"] = "ssbo";
  if (const GLenum error = take_error(gl_); error != GL_NO_ERROR)
    problem_ = fmt::format("preparing the context raised {}", name_of_error(error));
}

void SceneRenderer::describe(const GlContext& context) {
  const auto text = [&](GLenum name) {
    const GLubyte* value = gl_.GetString(name);
    return std::string(value == nullptr ? "" : reinterpret_cast<const char*>(value));
  };
  const auto integer = [&](GLenum name) {
    GLint value = 0;
    gl_.GetIntegerv(name, &value);
    return value;
  };
  info_.vendor = text(GL_VENDOR);
  info_.version = text(GL_VERSION);
  info_.device = text(GL_RENDERER);
  info_.subpixel_bits = integer(GL_SUBPIXEL_BITS);
  gl_.GetIntegerv(GL_MAX_VIEWPORT_DIMS, max_viewport_);
  max_size_ = integer(GL_MAX_RENDERBUFFER_SIZE);
  info_.traits = {{"context", context.description()},
                  {"glsl", text(GL_SHADING_LANGUAGE_VERSION)},
                  {"max_samples", std::to_string(integer(GL_MAX_SAMPLES))},
                  {"max_viewport", fmt::format("{}x{}", max_viewport_[0], max_viewport_[1])},
                  {"capture", "none"}};
}

std::string SceneRenderer::limit_exceeded_by(const Scene& scene) const {
  const Target& target = scene.target;
  if (target.samples != 1)
    return fmt::format("targets with {} samples are not drawn here", target.samples);
  if (target.width > max_size_ || target.height > max_size_)
    return fmt::format("a {}x{} target exceeds this driver's {}", target.width, target.height,
                       max_size_);
  if (scene.viewport.width > max_viewport_[0] || scene.viewport.height > max_viewport_[1])
    return fmt::format("a {}x{} viewport exceeds this driver's {}x{}", scene.viewport.width,
                       scene.viewport.height, max_viewport_[0], max_viewport_[1]);
  return "";
}

void SceneRenderer::upload(const Scene& scene) {
  const std::vector<GpuVertex> vertices = gpu_vertices(scene);
  gl_.BindVertexArray(objects_->vertex_array.name());
  gl_.BindBuffer(GL_ARRAY_BUFFER, objects_->vertices.name());
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(GpuVertex)),
                 vertices.data(), GL_STREAM_DRAW);
}

void SceneRenderer::draw_all(const Scene& scene, const GlProgram& program) {
  gl_.UseProgram(program.name());
  const bool counts = program.name() == objects_->programs.count.name();
  if (program.name() == objects_->programs.capture.name())
    gl_.Uniform1ui(kCapacityUniform, objects_->capture.capacity());
  GLint first = 0;
  for (const Draw& draw : scene.draws) {
    set_state(gl_, scene, draw);
    if (counts) {
      gl_.Enable(GL_BLEND);
      gl_.BlendEquation(GL_FUNC_ADD);
      gl_.BlendFunc(GL_ONE, GL_ONE);
    } else {
      gl_.Disable(GL_BLEND);
      gl_.Uniform1i(kSmoothUniform, draw.interpolation == Interpolation::smooth ? 1 : 0);
    }
    // What does not fill a primitive was not uploaded.
    const int step = vertices_per_primitive(draw.primitive);
    const GLsizei count = static_cast<GLsizei>(draw.vertices.size()) / step * step;
    gl_.DrawArrays(mode_of(draw.primitive), first, count);
    first += count;
  }
}

std::optional<std::string> SceneRenderer::capture_fragments(const Scene& scene,
                                                            Rendering& rendering) {
  Capture& capture = objects_->capture;
  // A second attempt has room for what the first one counted.
  for (int attempt = 0; attempt < 2; ++attempt) {
    capture.begin();
    draw_all(scene, objects_->programs.capture);
    const std::uint32_t count = capture.count();
    if (count <= capture.capacity()) {
      rendering.fragments = capture.read(count);
      return std::nullopt;
    }
    if (count > capture.limit())
      return fmt::format("the scene has {} fragments, and there is room to capture {}", count,
                         capture.limit());
    capture.grow(count);
  }
  return "drawing the same scene twice gave different numbers of fragments";
}

Outcome SceneRenderer::render(const Scene& scene) {
  std::string problem = problem_.empty() ? limit_exceeded_by(scene) : problem_;
  if (!problem.empty()) return Failure{FailureKind::unsupported, problem};
  const int width = scene.target.width;
  const int height = scene.target.height;
  const TargetBuffers* target = objects_->targets.find(width, height);
  if (target == nullptr)
    return Failure{FailureKind::unsupported,
                   fmt::format("this driver has no {}x{} framebuffer", width, height)};
  Rendering rendering;
  rendering.width = width;
  rendering.height = height;
  const std::size_t area = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  upload(scene);

  clear(gl_, target->color, scene.target.clear);
  draw_all(scene, objects_->programs.color);
  rendering.pixels.resize(4 * area);
  gl_.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rendering.pixels.data());

  clear(gl_, target->count, {0, 0, 0, 0});
  draw_all(scene, objects_->programs.count);
  std::vector<float> counts(area);
  gl_.ReadPixels(0, 0, width, height, GL_RED, GL_FLOAT, counts.data());
  rendering.hits.assign(counts.begin(), counts.end());

  gl_.BindFramebuffer(GL_FRAMEBUFFER, target->color.name());
  const auto overflow = capture_fragments(scene, rendering);
  if (const GLenum error = take_error(gl_); error != GL_NO_ERROR)
    return Failure{error == GL_CONTEXT_LOST ? FailureKind::crashed : FailureKind::unsupported,
                   fmt::format("drawing raised {}", name_of_error(error))};
  if (overflow) return Failure{FailureKind::unsupported, *overflow};
  return rendering;
}

}  // namespace edgecase
