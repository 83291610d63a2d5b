// SPDX-License-Identifier: MIT
#include "reference/shader_heads.h"

#include "reference/gl_api.h"

namespace edgecase {

namespace {

constexpr const char* kHighPrecision =
    "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
    "precision highp sampler2DMS;\nprecision highp usampler2DMS;\n";

std::string require(const std::string& extension) {
  return "#extension " + extension + " : require\n";
}

// Features of GLSL ES 3.20 are extensions in 3.10.
std::string es_head(const GladGLContext& gl, bool of_fragments) {
  const bool is_3_2 = gl.ES_VERSION_3_2 != 0;
  std::string head = is_3_2 ? "#version 320 es\n" : "#version 310 es\n";
  if (!is_3_2 && gl.OES_shader_multisample_interpolation)
    head += require("GL_OES_shader_multisample_interpolation");
  if (!is_3_2 && of_fragments && gl.OES_sample_variables)
    head += require("GL_OES_sample_variables");
  if (of_fragments && gl.EXT_texture_query_lod)
    head += require("GL_EXT_texture_query_lod") + "#define textureQueryLod textureQueryLOD\n";
  const bool has_noperspective = gl.NV_shader_noperspective_interpolation != 0;
  if (has_noperspective) head += require("GL_NV_shader_noperspective_interpolation");
  head += has_noperspective ? "#define NOPERSPECTIVE noperspective\n"
                            : "#define NOPERSPECTIVE smooth\n";
  return head + kHighPrecision;
}

constexpr const char* kNoperspective = "#define NOPERSPECTIVE noperspective\n";
constexpr const char* kFine = "#define FINE_AND_COARSE\n";

}  // namespace

std::string head_of_vertices(const GladGLContext& gl) {
  if (is_es(gl)) return es_head(gl, false) + "#define POINT_SIZE\n";
  return std::string("#version 430 core\n") + kNoperspective;
}

std::string head_of_fragments(const GladGLContext& gl) {
  if (is_es(gl)) return es_head(gl, true);
  return std::string("#version 430 core\n") + kNoperspective;
}

std::vector<std::string> fine_heads_of_fragments(const GladGLContext& gl) {
  if (is_es(gl)) return {};
  // Part of GLSL 4.50, and an extension before.
  return {std::string("#version 450 core\n") + kNoperspective + kFine,
          "#version 430 core\n" + require("GL_ARB_derivative_control") + kNoperspective + kFine};
}

}  // namespace edgecase
