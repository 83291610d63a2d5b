// SPDX-License-Identifier: MIT
//
// The GL programs, compiled once: a program per case would cost more than all drawing.
//
// Four serve every scene without textures. A scene with textures has programs by the form of each
// draw's lookup, made when it first comes. Each has one lookup: llvmpipe compiles a shader anew
// for each state of a sampler, and one that has every kind of lookup takes three times as long.
//
// A multisampled scene has programs by where each draw's attributes are evaluated, made when it
// first comes: the qualifiers centroid and sample are part of a shader's text, and reading
// gl_SampleMaskIn would burden all other scenes.
//
// All share one vertex shader, so that every pass rasterizes the same primitives. What differs from
// draw to draw is a uniform or a vertex attribute. The primitive's number travels as a flat
// attribute, reference/vertex_data.h: gl_PrimitiveID makes a shader draw nothing on one driver and
// is garbage on another.
//
// Derivatives are taken of the colour that the uniform chose, before anything else is done: in
// uniform control flow, where they are defined (GLSL 4.60, 8.14.1). Of a textured draw, that
// attribute holds s, t, 0 and 1, and the colour is looked up thereafter.
#pragma once

#include <compare>
#include <string>
#include <variant>

#include "model/sampling.h"
#include "model/texture.h"
#include "reference/gl_objects.h"

namespace edgecase {

// Attribute locations of the vertex shader.
constexpr GLuint kPositionAttribute = 0;   // vec4, clip coordinates
constexpr GLuint kColorAttribute = 1;      // vec4
constexpr GLuint kPrimitiveAttribute = 2;  // int

// Uniform locations of the fragment shaders.
constexpr GLint kInterpolationUniform = 0;  // int: which of the colours below is taken
constexpr GLint kCapacityUniform = 1;       // uint: records that the capture's buffer has room for
constexpr GLint kStepUniform = 2;           // float: what the count program writes
constexpr GLint kLookupValueUniform = 3;    // float: of lookups by bias and by level of detail
constexpr GLint kGradientsUniform = 4;      // vec4: ds/dx, dt/dx, ds/dy, dt/dy
constexpr GLint kPointSizeUniform = 5;      // float, of the vertex shader, of OpenGL ES alone

constexpr GLint kFlatColor = 0;
constexpr GLint kSmoothColor = 1;
constexpr GLint kNoperspectiveColor = 2;

// Binding of the capture's buffer.
constexpr GLuint kCaptureBinding = 0;

struct Programs {
  GlProgram color;    // writes the fragment's colour
  GlProgram count;    // writes the step to the red channel; of multisampled scenes, alpha as well
  GlProgram capture;  // writes the colour, and appends a record: see reference/capture.h
  GlProgram details;  // the same with a detailed record
  // Are dFdxFine, dFdyFine, dFdxCoarse and dFdyCoarse in that record? Without GLSL 4.50 and
  // GL_ARB_derivative_control there are none, and their places hold zeros.
  bool fine_and_coarse = false;
};

// What a program for textured scenes looks up. The default is a draw of such a scene without a
// texture: it has the vertices' colour, and the same records as the rest of its scene.
struct LookupForm {
  int dimensions = 0;  // of the texture, 1 or 2
  LookupKind kind = LookupKind::implicit;
  friend auto operator<=>(const LookupForm&, const LookupForm&) = default;
};

// Why there are no programs, one sentence with the driver's own words.
struct ProgramError {
  std::string message;
};

// Compiles the four of scenes without textures. The context must have GL 4.3 or GL ES 3.1, or
// later, and be current.
std::variant<Programs, ProgramError> make_programs(const GladGLContext& gl);

// Compiles the four of multisampled scenes. Their records tell which samples a fragment covers, and
// their count program writes the alpha of the colour, on which alpha to coverage depends.
std::variant<Programs, ProgramError> make_sampled_programs(const GladGLContext& gl,
                                                           AttributeLocation location);

// Has the driver's GLSL textureQueryLod? By trying.
bool can_query_level_of_detail(const GladGLContext& gl);

// Compiles those of scenes with textures; `count` is left empty. The image is at the unit of
// reference/textures.h. `query`: the detailed record holds what textureQueryLod tells of an
// implicit lookup; else, and of other lookups, it holds zeros.
std::variant<Programs, ProgramError> make_texture_programs(const GladGLContext& gl, LookupForm form,
                                                           bool query);

// Compiles one program of any two shaders, given without a version: they are of GLSL 4.30, or of
// GLSL ES 3.10.
std::variant<GlProgram, ProgramError> make_program(const GladGLContext& gl,
                                                   const std::string& vertex,
                                                   const std::string& fragment);

}  // namespace edgecase
