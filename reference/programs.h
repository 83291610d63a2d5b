// SPDX-License-Identifier: MIT
//
// The GL programs, compiled once: a program per case would cost more than all drawing.
//
// A few programs serve every scene without textures. Textured scenes have programs by the form of
// each draw's lookup, made on first use. Each has one lookup: llvmpipe recompiles a shader for each
// state of a sampler, and one with every kind of lookup takes three times as long.
//
// Multisampled scenes have programs by where each draw's attributes are evaluated, made on first
// use: the qualifiers centroid and sample are part of a shader's text, and reading gl_SampleMaskIn
// would slow all other scenes.
//
// All share one vertex shader and the inputs of the fragment shader, so that every pass rasterizes
// the same primitives. Differences between draws are uniforms or vertex attributes. The primitive's
// number is a flat attribute, reference/vertex_data.h: gl_PrimitiveID makes a shader draw nothing
// on one driver and is garbage on another.
//
// Derivatives are taken of the colour that the uniform chose, before anything else: in uniform
// control flow, where they are defined (GLSL 4.60, 8.14.1). In a textured draw, that attribute is
// (s, t, 0, 1), and the colour is looked up afterwards.
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

// Numbers of the fragment shaders' uniforms, of which GlProgram::location makes locations.
constexpr GLint kInterpolationUniform = 0;  // int: which of the colours below is used
constexpr GLint kCapacityUniform = 1;       // uint: the capacity of the capture's buffer in records
constexpr GLint kStepUniform = 2;           // float: the count program's output
constexpr GLint kLookupValueUniform = 3;    // float: for lookups by bias and by level of detail
constexpr GLint kGradientsUniform = 4;      // vec4: ds/dx, dt/dx, ds/dy, dt/dy
constexpr GLint kPointSizeUniform = 5;      // float, in the vertex shader, only in OpenGL ES
constexpr GLint kPartUniform = 6;           // int: which part of a record is drawn as a colour

constexpr GLint kFlatColor = 0;
constexpr GLint kSmoothColor = 1;
constexpr GLint kNoperspectiveColor = 2;

// Binding of the capture's buffer.
constexpr GLuint kCaptureBinding = 0;

// Texture unit of the image that limits which primitives are captured: reference/word_capture.h.
constexpr GLuint kLimitsUnit = 2;

struct Programs {
  GlProgram color;  // writes the fragment's colour
  GlProgram timed;  // the same at the least cost: what benchmarks draw with
  GlProgram count;  // writes the step to red; in multisampled scenes, alpha as well
  // Writes the colour, and appends a record: see reference/capture.h. Without storage blocks it
  // writes a part of the record instead of the colour: see reference/word_capture.h.
  GlProgram capture;
  GlProgram details;  // the same with a detailed record
  // Whether that record has dFdxFine, dFdyFine, dFdxCoarse and dFdyCoarse. Without GLSL 4.50 and
  // GL_ARB_derivative_control they are zeros.
  bool fine_and_coarse = false;
};

// The lookup of a program for textured scenes. The default is a draw without a texture in such a
// scene: it has the vertices' colour, and the same records as the rest of the scene.
struct LookupForm {
  int dimensions = 0;  // of the texture, 1 or 2
  LookupKind kind = LookupKind::implicit;
  friend auto operator<=>(const LookupForm&, const LookupForm&) = default;
};

// Why there are no programs: one sentence with the driver's own message.
struct ProgramError {
  std::string message;
};

// Compiles the programs for scenes without textures. The context must be current and have at
// least GL 3.3 or GL ES 3.0.
std::variant<Programs, ProgramError> make_programs(const GladGLContext& gl);

// Compiles the programs for multisampled scenes. Their records include the covered samples,
// and their count program writes the colour's alpha, on which alpha to coverage depends.
std::variant<Programs, ProgramError> make_sampled_programs(const GladGLContext& gl,
                                                           AttributeLocation location);

// Whether the driver's GLSL has textureQueryLod, found by trying.
bool can_query_level_of_detail(const GladGLContext& gl);

// Compiles the programs for scenes with textures, without `count`. The image is at the unit of
// reference/textures.h. `query`: the detailed record has the result of textureQueryLod for an
// implicit lookup; otherwise zeros.
std::variant<Programs, ProgramError> make_texture_programs(const GladGLContext& gl, LookupForm form,
                                                           bool query);

// Compiles one program of any two shaders, given without a version, in GLSL 4.30 or GLSL ES 3.10
// or, where the context has less, without their layouts of uniforms.
std::variant<GlProgram, ProgramError> make_program(const GladGLContext& gl,
                                                   const std::string& vertex,
                                                   const std::string& fragment);

}  // namespace edgecase
