// SPDX-License-Identifier: MIT
#include "reference/es_limits.h"

#include <algorithm>

#include "model/side_clipping.h"

namespace edgecase {

namespace {

std::string target_beyond_es(const Scene& scene, const EsFeatures& features) {
  const Target& target = scene.target;
  if (scene.details.derivatives) return "OpenGL ES has no fine and no coarse derivatives";
  if (target.depth != DepthFormat::none && !features.reads_depths)
    return "a depth buffer cannot be read on this driver: its OpenGL ES lacks GL_NV_read_depth";
  if (target.stencil != StencilFormat::none && !features.reads_stencils)
    return "a stencil buffer cannot be read on this driver: its OpenGL ES lacks GL_NV_read_stencil";
  if (target.surface == Surface::fbo && !features.float_targets)
    return "hits cannot be counted on this driver: its OpenGL ES lacks GL_EXT_color_buffer_float "
           "or "
           "GL_EXT_float_blend";
  if (target.samples > 1 && !features.samples)
    return "fragments do not tell their samples on this driver: its OpenGL ES lacks "
           "GL_OES_sample_variables or GL_OES_shader_multisample_interpolation";
  return "";
}

std::string textures_beyond_es(const Scene& scene, const EsFeatures& features) {
  for (const auto& texture : scene.textures) {
    if (texture->dimensions == 1) return "OpenGL ES has no one-dimensional textures";
    if (holds_floats(texture->format) && texture->generated &&
        !(features.filters_floats && features.float_targets))
      return "levels of 32-bit floats are not generated on this driver: its OpenGL ES lacks "
             "GL_OES_texture_float_linear or GL_EXT_color_buffer_float";
  }
  return "";
}

std::string texture_use_beyond_es(const Texture& texture, const Sampler& sampler,
                                  const EsFeatures& features) {
  if (sampler.lod_bias != 0) return "OpenGL ES has no bias of a sampler's level of detail";
  const auto& wrap = sampler.wrap;
  if (!features.borders && std::find(wrap.begin(), wrap.end(), Wrap::clamp_to_border) != wrap.end())
    return "this driver's textures have no borders: its OpenGL ES lacks "
           "GL_OES_texture_border_clamp and GL_EXT_texture_border_clamp";
  const bool filters = sampler.magnify == Filter::linear || sampler.minify == Filter::linear ||
                       sampler.mipmap == MipFilter::linear;
  if (holds_floats(texture.format) && filters && !features.filters_floats)
    return "32-bit floats are not filtered on this driver: its OpenGL ES lacks "
           "GL_OES_texture_float_linear";
  return "";
}

std::string draw_beyond_es(const Draw& draw, const Scene& scene, const EsFeatures& features) {
  // A point has one vertex.
  if (draw.provoking_vertex == ProvokingVertex::first &&
      kind_of(draw.primitive) != PrimitiveKind::point)
    return "OpenGL ES has no first vertex convention: a primitive's last vertex provokes";
  if (draw.interpolation == Interpolation::noperspective && !features.noperspective)
    return "this driver does not interpolate without perspective: its OpenGL ES lacks "
           "GL_NV_shader_noperspective_interpolation";
  if (scene.target.samples > 1) {
    if (!draw.multisampling.enabled) return "OpenGL ES cannot switch multisampling off";
    if (draw.multisampling.min_sample_shading && !features.sample_shading)
      return "samples cannot be made to have invocations of their own on this driver: its OpenGL "
             "ES lacks GL_OES_sample_shading";
  }
  if (draw.texture)
    if (std::string problem = texture_use_beyond_es(*scene.textures[draw.texture->texture],
                                                    draw.texture->sampler, features);
        !problem.empty())
      return problem;
  return "";
}

}  // namespace

EsFeatures es_features(const GladGLContext& gl) {
  const bool is_3_2 = gl.ES_VERSION_3_2 != 0;
  EsFeatures features;
  features.noperspective = gl.NV_shader_noperspective_interpolation != 0;
  features.sampled_textures = gl.ES_VERSION_3_1 != 0;
  features.samples =
      is_3_2 || (gl.OES_sample_variables != 0 && gl.OES_shader_multisample_interpolation != 0);
  features.sample_shading = gl.MinSampleShading != nullptr;
  features.borders = is_3_2 || gl.OES_texture_border_clamp != 0 || gl.EXT_texture_border_clamp != 0;
  features.filters_floats = gl.OES_texture_float_linear != 0;
  features.float_targets = (is_3_2 || gl.EXT_color_buffer_float != 0) && gl.EXT_float_blend != 0;
  features.reads_depths = gl.NV_read_depth != 0;
  features.reads_stencils = gl.NV_read_stencil != 0;
  return features;
}

std::string beyond_es(const Scene& scene, const EsFeatures& features) {
  if (std::string problem = target_beyond_es(scene, features); !problem.empty()) return problem;
  if (std::string problem = textures_beyond_es(scene, features); !problem.empty()) return problem;
  for (const Draw& draw : scene.draws)
    if (std::string problem = draw_beyond_es(draw, scene, features); !problem.empty())
      return problem;
  return SceneOfApi(scene, true).is_exact() ? "" : kBeyondExactSides;
}

}  // namespace edgecase
