// SPDX-License-Identifier: MIT
#include "reference/scene_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "reference/depth_buffer.h"
#include "reference/draw_state.h"
#include "reference/provoking_probe.h"
#include "reference/vertex_data.h"

namespace edgecase {

namespace {

// The value of the interpolation uniform.
GLint to_uniform(Interpolation interpolation) {
  switch (interpolation) {
    case Interpolation::flat:
      return kFlatColor;
    case Interpolation::smooth:
      return kSmoothColor;
    case Interpolation::noperspective:
      return kNoperspectiveColor;
  }
  return kFlatColor;
}

std::size_t area_of(const Rendering& rendering) {
  return static_cast<std::size_t>(rendering.width) * static_cast<std::size_t>(rendering.height);
}

std::string text_of(const std::array<float, 2>& range) {
  return fmt::format("{:g} to {:g}", range[0], range[1]);
}

}  // namespace

SceneRenderer::Objects::Objects(const GladGLContext& gl, GlContext& context, Programs made)
    : programs(std::move(made)),
      capture(gl, Capture::Form::plain),
      detailed_capture(gl, Capture::Form::detailed),
      targets(gl, context),
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

SceneRenderer::SceneRenderer(GlContext& context) {
  const auto load = [](void* user, const char* name) {
    return static_cast<const GlContext*>(user)->get_proc(name);
  };
  const int version = gladLoadGLContextUserPtr(&gl_, load, &context);
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
  objects_.emplace(gl_, context, std::move(std::get<Programs>(programs)));
  info_.traits["capture"] = "ssbo";
  info_.traits["derivatives"] = objects_->programs.fine_and_coarse ? "plain fine coarse" : "plain";
  if (const GLenum error = take_error(gl_); error != GL_NO_ERROR)
    problem_ = fmt::format("preparing the context raised {}", name_of_error(error));
  else
    probe_provoking_vertices();
}

void SceneRenderer::probe_provoking_vertices() {
  std::string names;
  for (ProvokingVertex which : {ProvokingVertex::first, ProvokingVertex::last}) {
    bool& works = provoking_[static_cast<std::size_t>(which)];
    for (Primitive primitive : {Primitive::lines, Primitive::triangles}) {
      const Scene scene = provoking_scene(primitive, which);
      const Outcome outcome = render(scene);
      // What cannot be drawn at all says so to every scene.
      const auto* rendering = std::get_if<Rendering>(&outcome);
      if (rendering != nullptr && !obeys(*rendering, scene)) works = false;
    }
    if (works) names += (names.empty() ? "" : " ") + std::string(name_of(which));
  }
  info_.traits["provoking_vertices"] = names.empty() ? "none" : names;
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
  gl_.GetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, line_widths_.data());
  gl_.GetFloatv(GL_POINT_SIZE_RANGE, point_sizes_.data());
  // Wide lines are deprecated, and an error in contexts that promise to do without.
  if ((integer(GL_CONTEXT_FLAGS) & GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT) != 0)
    line_widths_[1] = std::min(line_widths_[1], 1.0f);
  info_.traits = {{"context", context.description()},
                  {"glsl", text(GL_SHADING_LANGUAGE_VERSION)},
                  {"max_samples", std::to_string(integer(GL_MAX_SAMPLES))},
                  {"max_viewport", fmt::format("{}x{}", max_viewport_[0], max_viewport_[1])},
                  {"line_widths", text_of(line_widths_)},
                  {"point_sizes", text_of(point_sizes_)},
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
  for (const Draw& draw : scene.draws)
    if (std::string problem = limit_exceeded_by(draw); !problem.empty()) return problem;
  return "";
}

std::string SceneRenderer::limit_exceeded_by(const Draw& draw) const {
  const PrimitiveKind kind = kind_of(draw.primitive);
  const double size = draw.point_size.to_double();
  if (kind == PrimitiveKind::point &&
      (size < static_cast<double>(point_sizes_[0]) || size > static_cast<double>(point_sizes_[1])))
    return fmt::format("points of size {} are not drawn by this driver: it has {}", size,
                       text_of(point_sizes_));
  // A width is rounded to a whole number, at least 1 (GL 4.6 core, 14.5.2.1).
  const double width = draw.line_width.to_double();
  if (kind == PrimitiveKind::line &&
      std::floor(width + 0.5) > std::max(1.0, static_cast<double>(line_widths_[1])))
    return fmt::format("lines of width {} are not drawn by this driver: it has {}", width,
                       text_of(line_widths_));
  // A point has one vertex.
  if (kind != PrimitiveKind::point && !provoking_[static_cast<std::size_t>(draw.provoking_vertex)])
    return fmt::format("setting the {} vertex to provoke has no effect on this driver",
                       name_of(draw.provoking_vertex));
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
  GLint first = 0;
  for (const Draw& draw : scene.draws) {
    set_state(gl_, scene, draw);
    if (counts) {
      gl_.Enable(GL_BLEND);
      gl_.BlendEquation(GL_FUNC_ADD);
      gl_.BlendFunc(GL_ONE, GL_ONE);
    } else {
      gl_.Disable(GL_BLEND);
      gl_.Uniform1i(kInterpolationUniform, to_uniform(draw.interpolation));
    }
    const auto count = static_cast<GLsizei>(draw.vertices.size());
    gl_.DrawArrays(mode_of(draw.primitive), first, count);
    first += count;
  }
}

void SceneRenderer::clear_for(const Scene& scene, GLuint framebuffer, const Color& color) {
  clear(gl_, framebuffer, color, scene.target.depth != DepthFormat::none);
}

void SceneRenderer::draw_pixels(const Scene& scene, const Surfaces& surfaces,
                                Rendering& rendering) {
  clear_for(scene, surfaces.color, scene.target.clear);
  draw_all(scene, objects_->programs.color);
  rendering.pixels.resize(4 * area_of(rendering));
  gl_.ReadPixels(0, 0, rendering.width, rendering.height, GL_RGBA, GL_UNSIGNED_BYTE,
                 rendering.pixels.data());
  if (scene.target.depth != DepthFormat::none)
    rendering.depths = read_depths(gl_, scene.target.depth, rendering.width, rendering.height);
}

void SceneRenderer::count_hits(const Scene& scene, const Surfaces& surfaces, Rendering& rendering) {
  clear_for(scene, surfaces.count, {0, 0, 0, 0});
  gl_.UseProgram(objects_->programs.count.name());
  gl_.Uniform1f(kStepUniform, surfaces.step);
  draw_all(scene, objects_->programs.count);
  std::vector<float> sums(area_of(rendering));
  gl_.ReadPixels(0, 0, rendering.width, rendering.height, GL_RED, GL_FLOAT, sums.data());
  rendering.hits.resize(sums.size());
  std::transform(sums.begin(), sums.end(), rendering.hits.begin(), [&](float sum) {
    return static_cast<std::uint32_t>(std::lround(sum / surfaces.step));
  });
}

std::optional<std::string> SceneRenderer::capture_fragments(const Scene& scene,
                                                            const Surfaces& surfaces, bool detailed,
                                                            Rendering& rendering) {
  Capture& capture = detailed ? objects_->detailed_capture : objects_->capture;
  const GlProgram& program = detailed ? objects_->programs.details : objects_->programs.capture;
  gl_.BindFramebuffer(GL_FRAMEBUFFER, surfaces.color);
  // A second attempt has room for what the first one counted.
  for (int attempt = 0; attempt < 2; ++attempt) {
    capture.begin();
    gl_.UseProgram(program.name());
    gl_.Uniform1ui(kCapacityUniform, capture.capacity());
    draw_all(scene, program);
    const std::uint32_t count = capture.count();
    if (count <= capture.capacity()) {
      capture.read(count, rendering);
      return std::nullopt;
    }
    if (count > capture.limit())
      return fmt::format("the scene has {} fragments, and there is room to capture {}", count,
                         capture.limit());
    capture.grow(count);
  }
  return "drawing the same scene twice gave different numbers of fragments";
}

void SceneRenderer::drop_details(Details asked, Rendering& rendering) const {
  for (FragmentDetail& detail : rendering.details) {
    detail.has_coordinates = asked.coordinates;
    for (std::size_t i = 0; i < kDerivatives; ++i) {
      const bool is_plain = i <= static_cast<std::size_t>(Derivative::y);
      detail.has_derivative[i] =
          asked.derivatives && (is_plain || objects_->programs.fine_and_coarse);
    }
  }
}

std::string SceneRenderer::doubt_of(const Rendering& rendering, const Surfaces& surfaces) const {
  std::vector<std::uint32_t> counts(area_of(rendering));
  for (const Fragment& fragment : rendering.fragments) {
    if (fragment.primitive == kNoPrimitive)
      return fmt::format(
          "the fragment at pixel ({}, {}) has the flat attributes of a vertex that provokes no "
          "primitive",
          fragment.x, fragment.y);
    if (++counts[rendering.pixel_index(fragment.x, fragment.y)] > surfaces.most_hits)
      return fmt::format("pixel ({}, {}) has more hits than the {} that this surface can count",
                         fragment.x, fragment.y, surfaces.most_hits);
  }
  return "";
}

Outcome SceneRenderer::render(const Scene& scene, bool coverage_only) {
  std::string problem = problem_.empty() ? limit_exceeded_by(scene) : problem_;
  if (!problem.empty()) return Failure{FailureKind::unsupported, problem};
  const auto found = objects_->targets.find(scene.target);
  if (const auto* reason = std::get_if<std::string>(&found)) {
    take_error(gl_);
    return Failure{FailureKind::unsupported, *reason};
  }
  const Surfaces& surfaces = std::get<Surfaces>(found);
  Rendering rendering;
  rendering.width = scene.target.width;
  rendering.height = scene.target.height;
  upload(scene);
  if (!coverage_only) draw_pixels(scene, surfaces, rendering);
  count_hits(scene, surfaces, rendering);
  const bool detailed = scene.details.any() && !coverage_only;
  const auto overflow = capture_fragments(scene, surfaces, detailed, rendering);
  drop_details(scene.details, rendering);
  if (const GLenum error = take_error(gl_); error != GL_NO_ERROR)
    return Failure{error == GL_CONTEXT_LOST ? FailureKind::crashed : FailureKind::unsupported,
                   fmt::format("drawing raised {}", name_of_error(error))};
  if (overflow) return Failure{FailureKind::unsupported, *overflow};
  if (std::string doubt = doubt_of(rendering, surfaces); !doubt.empty())
    return Failure{FailureKind::unsupported, std::move(doubt)};
  return rendering;
}

}  // namespace edgecase
