// SPDX-License-Identifier: MIT
#include "reference/scene_renderer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "model/rendering_fields.h"
#include "reference/depth_buffer.h"
#include "reference/draw_state.h"
#include "reference/gl_api.h"
#include "reference/read_back.h"
#include "reference/rendering_doubt.h"
#include "reference/stencil_buffer.h"
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

bool is_multisampled(const Scene& scene) {
  return scene.target.samples > 1;
}

Multisampling without_alpha(Multisampling multisampling) {
  multisampling.alpha_to_coverage = false;
  return multisampling;
}

// The nearest whole number. Most numbers are whole already, and need no function call.
std::uint32_t hits_of(float steps) {
  constexpr float kEnd = 0x1p24f;
  if (steps >= 0 && steps < kEnd) {
    const auto whole = static_cast<std::int32_t>(steps);
    if (static_cast<float>(whole) == steps) return static_cast<std::uint32_t>(whole);
  }
  return static_cast<std::uint32_t>(std::lround(steps));
}

// "2 4 8"
std::string text_of(const std::vector<int>& numbers) {
  return numbers.empty() ? "none" : fmt::format("{}", fmt::join(numbers, " "));
}

}  // namespace

SceneRenderer::Objects::Objects(const GladGLContext& gl, GlContext& context, Programs made)
    : programs(gl, std::move(made)),
      words(gl),
      targets(gl, context),
      textures(gl),
      accumulator(gl),
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
  if (!has_storage_blocks(gl)) return;
  for (const auto form : {Capture::Form::plain, Capture::Form::detailed, Capture::Form::textured})
    captures[static_cast<std::size_t>(form)].emplace(gl, form);
}

SceneRenderer::SceneRenderer(GlContext& context) {
  if (!load_functions(gl_, context)) {
    problem_ = "the context offers no OpenGL functions";
    return;
  }
  describe(context);
  auto programs = make_programs(gl_);
  if (auto* error = std::get_if<ProgramError>(&programs)) {
    problem_ = error->message;
    return;
  }
  objects_.emplace(gl_, context, std::move(std::get<Programs>(programs)));
  describe_objects();
  if (const GLenum error = take_error(gl_); error != GL_NO_ERROR)
    problem_ = fmt::format("preparing the context raised {}", name_of_error(error));
  else
    probe_provoking_vertices();
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
  limits_ = stated_limits(gl_);
  info_.traits = {{"context", context.description()},
                  {"api", limits_.es ? "OpenGL ES" : "OpenGL"},
                  {"glsl", text(GL_SHADING_LANGUAGE_VERSION)},
                  {"max_samples", std::to_string(integer(GL_MAX_SAMPLES))},
                  {"max_viewport", fmt::format("{}x{}", limits_.viewport[0], limits_.viewport[1])},
                  {"line_widths", text_of_range(limits_.line_widths)},
                  {"point_sizes", text_of_range(limits_.point_sizes)},
                  {"max_texture_lod_bias", fmt::format("{:g}", limits_.texture_lod_bias)},
                  {"capture", "none"}};
  if (limits_.point_size_step > 0)
    info_.traits["point_size_steps"] = text_of_steps(limits_.point_sizes, limits_.point_size_step);
  if (limits_.sampled_line_width_step > 0)
    info_.traits["sampled_line_width_steps"] =
        text_of_steps(limits_.sampled_line_widths, limits_.sampled_line_width_step);
}

void SceneRenderer::describe_objects() {
  limits_.writes_storage = has_storage_blocks(gl_);
  limits_.queries_level_of_detail = can_query_level_of_detail(gl_);
  info_.traits["capture"] = limits_.writes_storage ? "ssbo" : "words";
  info_.traits["derivatives"] =
      objects_->programs.plain().fine_and_coarse ? "plain fine coarse" : "plain";
  info_.traits["level_of_detail"] = limits_.queries_level_of_detail ? "query" : "none";
  limits_.sample_counts = find_sample_counts(gl_);
  limits_.places_samples = can_place_samples(gl_);
  info_.traits["samples"] = text_of(limits_.sample_counts);
  limits_.derives_fine_and_coarse = objects_->programs.plain().fine_and_coarse;
  limits_.anisotropy = objects_->textures.max_anisotropy();
  info_.traits["max_anisotropy"] = fmt::format("{:g}", limits_.anisotropy);
}

void SceneRenderer::upload(const Scene& scene) {
  const std::vector<GpuVertex> vertices = gpu_vertices(scene);
  gl_.BindBuffer(GL_ARRAY_BUFFER, objects_->vertices.name());
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(GpuVertex)),
                 vertices.data(), GL_STREAM_DRAW);
}

void SceneRenderer::set_lookup(const Scene& scene, const Draw& draw, const GlProgram& program) {
  if (!draw.texture) return;
  const Lookup& lookup = draw.texture->lookup;
  objects_->textures.bind(scene.textures[draw.texture->texture], draw.texture->sampler);
  if (lookup.kind == LookupKind::bias || lookup.kind == LookupKind::lod)
    gl_.Uniform1f(program.location(kLookupValueUniform), lookup.value);
  if (lookup.kind == LookupKind::gradients)
    gl_.Uniform4f(program.location(kGradientsUniform), lookup.dx[0], lookup.dx[1], lookup.dy[0],
                  lookup.dy[1]);
}

void SceneRenderer::draw_all(const Scene& scene, const Pass& pass) {
  const bool has_more_state = uses_fragment_state(scene);
  gl_.BindVertexArray(objects_->vertex_array.name());
  GLint first = 0;
  for (const Draw& draw : scene.draws) {
    const GlProgram& program = objects_->programs.find(scene, draw, pass.looks_up).*pass.program;
    gl_.UseProgram(program.name());
    set_state(gl_, scene, draw, program);
    if (is_multisampled(scene))
      set_multisampling(gl_,
                        pass.writes_all() ? without_alpha(draw.multisampling) : draw.multisampling,
                        scene.target.samples);
    gl_.Disable(GL_BLEND);
    if (has_more_state) set_fragment_state(gl_, scene, draw, pass.kind);
    if (pass.counts()) {
      gl_.Enable(GL_BLEND);
      gl_.BlendEquation(GL_FUNC_ADD);
      gl_.BlendFunc(GL_ONE, GL_ONE);
      gl_.Uniform1f(program.location(kStepUniform), pass.step);
    }
    gl_.Uniform1i(program.location(kInterpolationUniform), to_uniform(draw.interpolation));
    if (pass.capture != nullptr)
      gl_.Uniform1ui(program.location(kCapacityUniform), pass.capture->capacity());
    else if (pass.writes_all() && !pass.counts())
      gl_.Uniform1i(program.location(kPartUniform), pass.part);
    if (pass.looks_up) set_lookup(scene, draw, program);
    const auto count = static_cast<GLsizei>(draw.vertices.size());
    gl_.DrawArrays(mode_of(draw.primitive), first, count);
    if (pass.finishes) gl_.Finish();
    first += count;
  }
  if (is_multisampled(scene)) set_multisampling(gl_, {}, scene.target.samples);
  if (has_more_state) reset_fragment_state(gl_);
}

void SceneRenderer::clear_for(const Scene& scene, GLuint framebuffer, const Color& color) {
  clear(gl_, framebuffer, color);
  clear_depth_and_stencil(gl_, scene.target);
}

void SceneRenderer::draw_pixels(const Scene& scene, const Surfaces& surfaces,
                                Rendering& rendering) {
  clear_for(scene, surfaces.color, scene.target.clear);
  draw_all(scene, {&Programs::color, is_textured(scene)});
  if (surfaces.multisampled != nullptr) return read_samples(*surfaces.multisampled, rendering);
  rendering.pixels.resize(4 * area_of(rendering));
  gl_.ReadPixels(0, 0, rendering.width, rendering.height, GL_RGBA, GL_UNSIGNED_BYTE,
                 rendering.pixels.data());
  if (scene.target.depth != DepthFormat::none)
    rendering.depths = read_depths(gl_, scene.target.depth, rendering.width, rendering.height);
  if (scene.target.stencil != StencilFormat::none)
    rendering.stencils = read_stencils(gl_, rendering.width, rendering.height);
}

void SceneRenderer::read_samples(const MultisampleTarget& target, Rendering& rendering) {
  const SampleReader& reader = objects_->targets.samples();
  rendering.pixels = reader.resolved(target);
  rendering.sample_pixels = reader.colors(target);
  if (target.depth != DepthFormat::none)
    rendering.depths = reader.depths(target).value_or(std::vector<double>());
  if (target.stencil != StencilFormat::none)
    rendering.stencils = objects_->targets.stencils().read(target);
}

std::vector<float> SceneRenderer::read_sums(const Surfaces& surfaces, const HitCounter& counter,
                                            const Rendering& rendering) {
  if (surfaces.multisampled != nullptr)
    return objects_->targets.samples().counts(*surfaces.multisampled);
  std::vector<float> sums(area_of(rendering));
  const Channels channels = counter.step < 1 ? Channels::bytes : Channels::floats;
  read_red(gl_, channels, rendering.width, rendering.height, sums.data());
  return sums;
}

const HitCounter& SceneRenderer::counter_of(const Surfaces& surfaces,
                                            const Rendering& rendering) const {
  return surfaces.larger_count && has_pixel_of_more(rendering, surfaces.count.most_hits)
             ? *surfaces.larger_count
             : surfaces.count;
}

std::vector<std::uint32_t> SceneRenderer::count_hits(const Scene& scene, const Surfaces& surfaces,
                                                     PassKind kind, const Rendering& rendering) {
  const HitCounter& counter = counter_of(surfaces, rendering);
  clear_for(scene, counter.framebuffer, {0, 0, 0, 0});
  draw_all(scene, {.program = &Programs::count, .kind = kind, .step = counter.step});
  const std::vector<float> sums = read_sums(surfaces, counter, rendering);
  std::vector<std::uint32_t> hits(sums.size());
  std::transform(sums.begin(), sums.end(), hits.begin(),
                 [&](float sum) { return hits_of(sum / counter.step); });
  return hits;
}

std::optional<std::string> SceneRenderer::capture_fragments(const Scene& scene,
                                                            const Surfaces& surfaces,
                                                            bool coverage_only,
                                                            Rendering& rendering) {
  const bool looks_up = is_textured(scene) && !coverage_only;
  const bool detailed = scene.details.any() && !coverage_only;
  const Capture::Form form = !detailed  ? Capture::Form::plain
                             : looks_up ? Capture::Form::textured
                                        : Capture::Form::detailed;
  Pass pass{detailed ? &Programs::details : &Programs::capture, looks_up, PassKind::capture};
  if (!limits_.writes_storage)
    return capture_words(scene, surfaces, pass, form, coverage_only, rendering);
  Capture& capture = *objects_->captures[static_cast<std::size_t>(form)];
  pass.capture = &capture;
  gl_.BindFramebuffer(GL_FRAMEBUFFER, surfaces.color);
  // A second attempt has room for what the first one counted.
  for (int attempt = 0; attempt < 2; ++attempt) {
    capture.begin();
    draw_all(scene, pass);
    const std::uint32_t count = capture.count();
    if (count <= capture.capacity()) capture.read(count, scene.details, rendering);
    if (capture.lost()) return "the captured fragments cannot be read";
    if (count <= capture.capacity()) return std::nullopt;
    if (count > capture.limit())
      return fmt::format("the scene has {} fragments, and there is room to capture {}", count,
                         capture.limit());
    capture.grow(count);
  }
  return "drawing the same scene twice gave different numbers of fragments";
}

void SceneRenderer::drop_details(const Scene& scene, Rendering& rendering) const {
  if (rendering.details.empty()) return;
  const std::vector<ScenePrimitive> primitives = primitives_of(scene);
  for (const Fragment& fragment : rendering.fragments) {
    FragmentDetail& detail = rendering.details[static_cast<std::size_t>(fragment.detail)];
    const bool has_plain_alone =
        !objects_->programs.plain().fine_and_coarse && is_reported(detail.derivatives);
    for (std::size_t i = 2; i < kDerivatives && has_plain_alone; ++i) detail.derivatives[i].reset();
    if (fragment.primitive == kNoPrimitive) continue;  // a doubt, see below
    const auto& texture = primitives[static_cast<std::size_t>(fragment.primitive)].state->texture;
    for_each_field<FragmentDetail>([&](const auto& field) {
      if (!field.is_asked(scene.details, texture.has_value())) detail.*field.member = {};
    });
    if (texture &&
        !(limits_.queries_level_of_detail && texture->lookup.kind == LookupKind::implicit))
      detail.level_of_detail.reset();
  }
}

void SceneRenderer::report_mip_chains(const Scene& scene, Rendering& rendering) {
  for (std::size_t i = 0; i < scene.textures.size(); ++i)
    if (scene.textures[i]->generated)
      rendering.mip_chains[i] = objects_->textures.generated_chain(scene.textures[i]);
}

Outcome SceneRenderer::render_passes(const Scene& scene) {
  Accumulator& sum = objects_->accumulator;
  if (std::string problem = sum.begin(scene.target); !problem.empty())
    return Failure{FailureKind::unsupported, std::move(problem)};
  Rendering rendering;
  rendering.width = scene.target.width;
  rendering.height = scene.target.height;
  for (std::size_t k = 0; k < scene.supersampling.size(); ++k) {
    const Scene pass = pass_of(scene, k);
    Outcome outcome = render(pass);
    if (auto* failure = std::get_if<Failure>(&outcome)) return std::move(*failure);
    rendering.passes.push_back(std::get<Rendering>(std::move(outcome)));
    clear_for(pass, sum.pass(), pass.target.clear);
    draw_all(pass, {&Programs::color, is_textured(pass)});
    sum.add(scene.supersampling[k].weight);
  }
  sum.read(rendering);
  if (auto failure = take_failure()) return std::move(*failure);
  return rendering;
}

std::optional<Failure> SceneRenderer::take_failure() const {
  const GLenum error = take_error(gl_);
  if (error == GL_NO_ERROR) return std::nullopt;
  return Failure{error == GL_CONTEXT_LOST ? FailureKind::crashed : FailureKind::unsupported,
                 fmt::format("drawing raised {}", name_of_error(error))};
}

std::variant<Surfaces, Failure> SceneRenderer::prepare(const Scene& scene, bool looks_up) {
  if (std::string problem =
          objects_->programs.prepare(scene, looks_up, limits_.queries_level_of_detail);
      !problem.empty())
    return Failure{FailureKind::unsupported, std::move(problem)};
  auto found = objects_->targets.find(scene.target);
  if (auto* surfaces = std::get_if<Surfaces>(&found)) return *surfaces;
  take_error(gl_);
  return Failure{FailureKind::unsupported, std::get<std::string>(std::move(found))};
}

Outcome SceneRenderer::render(const Scene& scene, bool coverage_only) {
  if (std::string problem = problem_.empty() ? limit_exceeded_by(scene, limits_) : problem_;
      !problem.empty())
    return Failure{FailureKind::unsupported, std::move(problem)};
  if (!scene.supersampling.empty()) return render_passes(scene);
  const auto prepared = prepare(scene, is_textured(scene) && !coverage_only);
  if (const auto* failure = std::get_if<Failure>(&prepared)) return *failure;
  const Surfaces& surfaces = std::get<Surfaces>(prepared);
  Rendering rendering;
  rendering.width = scene.target.width;
  rendering.height = scene.target.height;
  rendering.samples = scene.target.samples;
  if (surfaces.multisampled != nullptr)
    rendering.sample_positions = surfaces.multisampled->positions;
  upload(scene);
  if (!coverage_only) draw_pixels(scene, surfaces, rendering);
  auto problem = capture_fragments(scene, surfaces, coverage_only, rendering);
  rendering.hits = count_hits(scene, surfaces, PassKind::hits, rendering);
  const std::uint32_t most_hits = counter_of(surfaces, rendering).most_hits;
  if (!limits_.writes_storage && !problem) problem = doubt_of_words(scene, surfaces, rendering);
  drop_details(scene, rendering);
  if (!coverage_only) report_mip_chains(scene, rendering);
  if (auto failure = take_failure()) return std::move(*failure);
  if (problem) return Failure{FailureKind::unsupported, *problem};
  if (std::string doubt = doubt_of(scene, rendering, most_hits); !doubt.empty())
    return Failure{FailureKind::unsupported, std::move(doubt)};
  return rendering;
}

}  // namespace edgecase
