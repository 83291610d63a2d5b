// SPDX-License-Identifier: MIT
#include "reference/shader_heads.h"

#include "reference/gl_api.h"

namespace edgecase {

namespace {

constexpr const char* kHighPrecision =
    "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
    "precision highp isampler2D;\n";
constexpr const char* kHighSamplePrecision =
    "precision highp sampler2DMS;\nprecision highp usampler2DMS;\n";
constexpr const char* kNoperspective = "#define NOPERSPECTIVE noperspective\n";
constexpr const char* kQueryLod = "#define textureQueryLod textureQueryLOD\n";
constexpr const char* kFine = "#define FINE_AND_COARSE\n";

std::string require(const std::string& extension) {
  return "#extension " + extension + " : require\n";
}

// Features of GLSL ES 3.20 are extensions in 3.10. Version 3.00 has no multisampled textures, so
// nothing is drawn with samples.
std::string es_head(const GladGLContext& gl, bool of_fragments) {
  const bool is_3_2 = gl.ES_VERSION_3_2 != 0;
  const bool is_3_0 = gl.ES_VERSION_3_1 == 0;
  std::string head = is_3_2   ? "#version 320 es\n"
                     : is_3_0 ? "#version 300 es\n"
                              : "#version 310 es\n";
  if (!is_3_2 && !is_3_0 && gl.OES_shader_multisample_interpolation)
    head += require("GL_OES_shader_multisample_interpolation");
  if (!is_3_2 && !is_3_0 && of_fragments && gl.OES_sample_variables)
    head += require("GL_OES_sample_variables");
  if (of_fragments && gl.EXT_texture_query_lod)
    head += require("GL_EXT_texture_query_lod") + kQueryLod;
  const bool has_noperspective = gl.NV_shader_noperspective_interpolation != 0;
  if (has_noperspective) head += require("GL_NV_shader_noperspective_interpolation");
  head += has_noperspective ? "#define NOPERSPECTIVE noperspective\n"
                            : "#define NOPERSPECTIVE smooth\n";
  return head + kHighPrecision + (is_3_0 ? "" : kHighSamplePrecision);
}

// Features of GLSL 4.00 are extensions in 3.30.
std::string gl_head(const GladGLContext& gl, bool of_fragments) {
  if (gl.VERSION_4_3) return "#version 430 core\n";
  if (gl.VERSION_4_0) return gl.VERSION_4_2 ? "#version 420 core\n" : "#version 400 core\n";
  std::string head = "#version 330 core\n";
  if (gl.ARB_gpu_shader5) head += require("GL_ARB_gpu_shader5");
  if (of_fragments && gl.ARB_texture_query_lod)
    head += require("GL_ARB_texture_query_lod") + kQueryLod;
  return head;
}

}  // namespace

std::string head_of_vertices(const GladGLContext& gl) {
  if (is_es(gl)) return es_head(gl, false) + "#define POINT_SIZE\n";
  return gl_head(gl, false) + kNoperspective;
}

std::string head_of_fragments(const GladGLContext& gl) {
  if (is_es(gl)) return es_head(gl, true);
  return gl_head(gl, true) + kNoperspective;
}

std::vector<std::string> fine_heads_of_fragments(const GladGLContext& gl) {
  if (is_es(gl)) return {};
  // Part of GLSL 4.50, and an extension before.
  return {std::string("#version 450 core\n") + kNoperspective + kFine,
          gl_head(gl, true) + require("GL_ARB_derivative_control") + kNoperspective + kFine};
}

}  // namespace edgecase
