// SPDX-License-Identifier: MIT
#include "reference/driver_limits.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "reference/draw_state.h"
#include "reference/drawn_keys.h"
#include "reference/gl_api.h"

namespace edgecase {

namespace {

// What OpenGL before 4.4 has by extensions; es_limits.cpp has those of OpenGL ES.
std::string sample_feature_limit(const Scene& scene, const DriverLimits& limits) {
  const Target& target = scene.target;
  if (!limits.tells_samples)
    return "fragments do not tell their samples on this driver: it lacks GL_ARB_gpu_shader5";
  const bool packed = target.depth != DepthFormat::none;
  if (target.stencil != StencilFormat::none &&
      !(packed ? limits.fetches_packed_stencils : limits.fetches_stencils))
    return fmt::format("samples' stencils cannot be read on this driver: it lacks {}",
                       packed ? "GL_ARB_stencil_texturing" : "GL_ARB_texture_stencil8");
  const auto shades = [](const Draw& draw) {
    return draw.multisampling.min_sample_shading.has_value();
  };
  if (!limits.shades_samples && std::any_of(scene.draws.begin(), scene.draws.end(), shades))
    return "samples cannot be made to have invocations of their own on this driver: it lacks "
           "GL_ARB_sample_shading";
  return "";
}

std::string sample_limit(const Scene& scene, const DriverLimits& limits) {
  const Target& target = scene.target;
  // Drawing elsewhere would follow another surface's rules.
  if (!scene.supersampling.empty() && target.surface == Surface::window)
    return "passes cannot be accumulated in a window: its colours have 8 bits";
  if (target.samples == 1) return "";
  if (target.surface == Surface::window) return "a window's samples cannot be chosen";
  if (limits.es && !limits.es->sampled_textures)
    return "OpenGL ES 3.0 has no multisampled textures, of which samples are read";
  if (limits.sample_counts.empty()) return "this driver has no multisampled targets";
  const auto& counts = limits.sample_counts;
  if (std::find(counts.begin(), counts.end(), target.samples) == counts.end())
    return fmt::format("asked for {} samples, this driver makes {}", target.samples,
                       fmt::join(counts, ", "));
  if (!target.sample_positions.empty() && !limits.places_samples)
    return "samples cannot be placed on this driver: it lacks GL_ARB_sample_locations";
  if (!scene.textures.empty()) return "textures are not drawn to multisampled targets";
  return sample_feature_limit(scene, limits);
}

std::string target_limit(const Scene& scene, const DriverLimits& limits) {
  const Target& target = scene.target;
  if (std::string problem = sample_limit(scene, limits); !problem.empty()) return problem;
  if (target.width > limits.size || target.height > limits.size)
    return fmt::format("a {}x{} target exceeds this driver's {}", target.width, target.height,
                       limits.size);
  if (scene.viewport.width > limits.viewport[0] || scene.viewport.height > limits.viewport[1])
    return fmt::format("a {}x{} viewport exceeds this driver's {}x{}", scene.viewport.width,
                       scene.viewport.height, limits.viewport[0], limits.viewport[1]);
  return "";
}

std::string size_limit(const Draw& draw, const Target& target, const DriverLimits& limits) {
  const PrimitiveKind kind = kind_of(draw.primitive);
  const double size = draw.point_size.to_double();
  if (kind == PrimitiveKind::point && (size < static_cast<double>(limits.point_sizes[0]) ||
                                       size > static_cast<double>(limits.point_sizes[1])))
    return fmt::format("points of size {} are not drawn by this driver: it has {}", size,
                       text_of_range(limits.point_sizes));
  if (kind != PrimitiveKind::line) return "";
  const double width = draw.line_width.to_double();
  if (is_multisampled(draw, target)) {
    // Not rounded, and in the range of antialiased lines (GL 4.6 core, 14.5.4).
    const auto& range = limits.sampled_line_widths;
    if (width >= static_cast<double>(range[0]) && width <= static_cast<double>(range[1])) return "";
    return fmt::format("multisampled lines of width {} are not drawn by this driver: it has {}",
                       width, text_of_range(range));
  }
  // A width is rounded to a whole number, at least 1 (GL 4.6 core, 14.5.2.2).
  if (std::floor(width + 0.5) > std::max(1.0, static_cast<double>(limits.line_widths[1])))
    return fmt::format("lines of width {} are not drawn by this driver: it has {}", width,
                       text_of_range(limits.line_widths));
  return "";
}

std::string operations_limit(const Draw& draw, const DriverLimits& limits) {
  if (draw.polygon_offset && draw.polygon_offset->clamp != 0 && !limits.clamps_polygon_offset)
    return fmt::format("polygon offsets cannot be clamped on this driver: it lacks {}",
                       limits.es ? "GL_EXT_polygon_offset_clamp" : "GL_ARB_polygon_offset_clamp");
  const auto& blending = draw.operations.blending;
  const auto saturates = [](const BlendTerm& term) {
    return term.destination == BlendFactor::src_alpha_saturate;
  };
  if (blending && !limits.saturates_destinations &&
      (saturates(blending->color) || saturates(blending->alpha)))
    return fmt::format("src_alpha_saturate is no destination's factor on this driver: it lacks {}",
                       limits.es ? "GL_EXT_blend_func_extended" : "GL_ARB_blend_func_extended");
  return "";
}

std::string draw_limit(const Draw& draw, const Target& target, const DriverLimits& limits) {
  if (std::string problem = size_limit(draw, target, limits); !problem.empty()) return problem;
  const float anisotropy = draw.texture ? draw.texture->sampler.max_anisotropy : 1;
  if (anisotropy > limits.anisotropy)
    return limits.anisotropy > 1 ? fmt::format("an anisotropy of {:g} exceeds this driver's {:g}",
                                               anisotropy, limits.anisotropy)
                                 : "this driver has no anisotropic filtering";
  if (std::string problem = operations_limit(draw, limits); !problem.empty()) return problem;
  // A point has one vertex.
  if (kind_of(draw.primitive) != PrimitiveKind::point &&
      !limits.provoking[static_cast<std::size_t>(draw.provoking_vertex)])
    return fmt::format("setting the {} vertex to provoke has no effect on this driver",
                       name_of(draw.provoking_vertex));
  return "";
}

// What shaders before OpenGL 4.3 and OpenGL ES 3.1 have by extensions, and what is told of
// fragments only by shaders that write to buffers.
std::string word_limit(const Scene& scene, const DriverLimits& limits) {
  if (limits.writes_storage) return "";
  if (scene.details.derivatives && !limits.derives_fine_and_coarse)
    return "there are no fine and no coarse derivatives on this driver: it lacks "
           "GL_ARB_derivative_control";
  for (const Draw& draw : scene.draws) {
    if (draw.texture && draw.texture->lookup.kind == LookupKind::implicit &&
        !limits.queries_level_of_detail)
      return fmt::format("levels of detail are not told on this driver: it lacks {}",
                         limits.es ? "GL_EXT_texture_query_lod" : "GL_ARB_texture_query_lod");
    const Multisampling& use = draw.multisampling;
    if (scene.target.samples > 1 && use.enabled && use.alpha_to_coverage &&
        (use.min_sample_shading || use.location == AttributeLocation::sample))
      return "alpha to coverage may take invocations of samples away on this driver, which "
             "fragments do not tell: it lacks GL_ARB_shader_storage_buffer_object";
  }
  return "";
}

bool takes_saturated_destinations(const GladGLContext& gl) {
  gl.BlendFunc(GL_ONE, GL_SRC_ALPHA_SATURATE);
  const bool takes = take_error(gl) == GL_NO_ERROR;
  gl.BlendFunc(GL_ONE, GL_ZERO);
  return takes;
}

// Limits that OpenGL ES reports differently, or that differ there.
void state_es_limits(const GladGLContext& gl, DriverLimits& limits) {
  limits.es = es_features(gl);
  limits.provoking[static_cast<std::size_t>(ProvokingVertex::first)] = false;
  // Version 3.1 has one range for all lines.
  limits.sampled_line_widths = limits.line_widths;
  if (gl.ES_VERSION_3_2)
    gl.GetFloatv(GL_MULTISAMPLE_LINE_WIDTH_RANGE, limits.sampled_line_widths.data());
  if (gl.ES_VERSION_3_2)
    gl.GetFloatv(GL_MULTISAMPLE_LINE_WIDTH_GRANULARITY, &limits.sampled_line_width_step);
  gl.GetFloatv(GL_ALIASED_POINT_SIZE_RANGE, limits.point_sizes.data());
  limits.clamps_polygon_offset = gl.EXT_polygon_offset_clamp != 0;
  limits.saturates_destinations = takes_saturated_destinations(gl);
}

}  // namespace

DriverLimits stated_limits(const GladGLContext& gl) {
  DriverLimits limits;
  gl.GetIntegerv(GL_MAX_VIEWPORT_DIMS, limits.viewport.data());
  gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &limits.size);
  gl.GetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, limits.line_widths.data());
  gl.GetFloatv(GL_MAX_TEXTURE_LOD_BIAS, &limits.texture_lod_bias);
  if (is_es(gl)) {
    state_es_limits(gl, limits);
    return limits;
  }
  gl.GetFloatv(GL_SMOOTH_LINE_WIDTH_RANGE, limits.sampled_line_widths.data());
  gl.GetFloatv(GL_SMOOTH_LINE_WIDTH_GRANULARITY, &limits.sampled_line_width_step);
  gl.GetFloatv(GL_POINT_SIZE_RANGE, limits.point_sizes.data());
  gl.GetFloatv(GL_POINT_SIZE_GRANULARITY, &limits.point_size_step);
  limits.clamps_polygon_offset =
      gl.VERSION_4_6 || gl.ARB_polygon_offset_clamp || gl.EXT_polygon_offset_clamp;
  limits.saturates_destinations = gl.ARB_blend_func_extended != 0;
  limits.tells_samples = gl.VERSION_4_0 || gl.ARB_gpu_shader5;
  limits.shades_samples = gl.MinSampleShading != nullptr;
  limits.fetches_packed_stencils = gl.VERSION_4_3 || gl.ARB_stencil_texturing;
  limits.fetches_stencils = gl.VERSION_4_4 || gl.ARB_texture_stencil8;
  // Wide lines are deprecated, and an error in forward-compatible contexts.
  GLint flags = 0;
  gl.GetIntegerv(GL_CONTEXT_FLAGS, &flags);
  if ((flags & GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT) != 0)
    for (auto* range : {&limits.line_widths, &limits.sampled_line_widths})
      (*range)[1] = std::min((*range)[1], 1.0f);
  return limits;
}

std::string limit_exceeded_by(const Scene& scene, const DriverLimits& limits) {
  if (const std::string key = key_not_drawn(scene); !key.empty())
    return fmt::format("\"{}\" is not drawn by OpenGL yet", key);
  if (std::string problem = target_limit(scene, limits); !problem.empty()) return problem;
  if (limits.es)
    if (std::string problem = beyond_es(scene, *limits.es); !problem.empty()) return problem;
  for (const Draw& draw : scene.draws)
    if (std::string problem = draw_limit(draw, scene.target, limits); !problem.empty())
      return problem;
  return word_limit(scene, limits);
}

std::string text_of_range(const std::array<float, 2>& range) {
  return fmt::format("{:g} to {:g}", range[0], range[1]);
}

std::string text_of_steps(const std::array<float, 2>& range, float step) {
  return fmt::format("{} by {}", range[0], step);
}

}  // namespace edgecase
