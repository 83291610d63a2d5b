// SPDX-License-Identifier: MIT
//
// The sources of the shaders that draw scenes. They contain neither a version nor where attributes
// are evaluated: reference/programs.cpp prepends these.
#pragma once

namespace edgecase::shaders {

// Heads of the shaders: where interpolated attributes are evaluated, what is switched on, and for
// textured scenes how colours are looked up. One function serves pixels and capture, so that both
// have the same colours. reference/shader_heads.h provides the version before them.
constexpr const char* kTimed = "#define TIMED\n";
constexpr const char* kDetails = "#define DETAILS\n";
constexpr const char* kStorage = "";
constexpr const char* kWords = "#define WORDS\n";
constexpr const char* kSamples = "#define SAMPLES\n";
constexpr const char* kAtCenter = "#define AT\n";
constexpr const char* kAtCentroid = "#define AT centroid\n";
constexpr const char* kAtSample = "#define AT sample\n";
constexpr const char* kQuery = "#define QUERY\n";

constexpr const char* kOneDimensional =
    "#define SAMPLER sampler1D\n#define ST x\n#define DX x\n#define DY z\n";
constexpr const char* kTwoDimensional =
    "#define SAMPLER sampler2D\n#define ST xy\n#define DX xy\n#define DY zw\n";
constexpr const char* kImage = R"(
layout(location = 3) uniform float lookup_value;
layout(location = 4) uniform vec4 gradients;
layout(binding = 0) uniform SAMPLER image;
)";
constexpr const char* kUntextured = R"(#define TEXTURES
vec4 looked_up(vec4 color) { return color; }
vec2 queried(vec4 color) { return vec2(0.0); }
)";
constexpr const char* kTextured = R"(#define TEXTURES
vec4 looked_up(vec4 color) { return LOOKUP; }
#ifdef QUERY
vec2 queried(vec4 color) { return textureQueryLod(image, color.ST); }
#else
vec2 queried(vec4 color) { return vec2(0.0); }
#endif
)";

// One triangle, of three vertices without attributes, that covers the viewport.
constexpr const char* kEverywhere = R"(
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";

constexpr const char* kVertexShader = R"(
layout(location = 0) in vec4 position;
layout(location = 1) in vec4 color;
layout(location = 2) in int primitive;
flat out vec4 flat_color;
smooth AT out vec4 smooth_color;
NOPERSPECTIVE AT out vec4 noperspective_color;
flat out int primitive_index;
#ifdef POINT_SIZE
layout(location = 5) uniform float point_size;
#endif
void main() {
  gl_Position = position;
#ifdef POINT_SIZE
  gl_PointSize = point_size;
#endif
  flat_color = color;
  smooth_color = color;
  noperspective_color = color;
  primitive_index = primitive;
}
)";

// The inputs of all fragment shaders. They are the same, and each uses all of them, since llvmpipe
// compiles what it sets triangles up with anew for other inputs, and for each polygon offset: a
// scene has one such program instead of one for each pass, and is set up alike in all of them. No
// vertex has a number below kNoPrimitive (reference/vertex_data.h), so that gl_FragCoord is never
// drawn. What is TIMED has only the inputs that it needs: others take llvmpipe up to 1.5 times as
// long.
constexpr const char* kInputs = R"(
flat in vec4 flat_color;
smooth AT in vec4 smooth_color;
NOPERSPECTIVE AT in vec4 noperspective_color;
flat in int primitive_index;
layout(location = 0) uniform int interpolation;
vec4 interpolated() {
  vec4 color = interpolation == 0 ? flat_color
                                  : (interpolation == 1 ? smooth_color : noperspective_color);
#ifdef TIMED
  return color;
#else
  return primitive_index < -1 ? gl_FragCoord : color;
#endif
}
)";

constexpr const char* kColorShader = R"(
layout(location = 0) out vec4 target;
void main() {
  vec4 color = interpolated();
#ifdef TEXTURES
  color = looked_up(color);
#endif
  target = color;
}
)";

// By the colour's alpha, alpha to coverage decides which samples of a multisampled target are hit.
// The limit is another than that of interpolated(), whose colours a compiler could leave out else.
constexpr const char* kCountShader = R"(
layout(location = 2) uniform float hit_step;
layout(location = 0) out vec4 target;
void main() {
  vec4 color = interpolated();
  target = primitive_index < -2 ? color : vec4(hit_step, 0.0, 0.0, color.a);
}
)";

// Without a version, and in two forms: DETAILS adds what reference/capture.h calls details, and
// FINE_AND_COARSE the derivatives that not every GLSL has. The counter continues beyond the
// capacity, so that an overflow shows how much room is needed. SAMPLES, for multisampled targets,
// puts the coverage into the upper half of x, which suffices for 16 samples and 4096 columns.
//
// WORDS is for contexts without storage blocks: the record, without x and y, is an array of words,
// of which a pass draws three bytes and a tag (reference/word_capture.h).
constexpr const char* kCaptureShader = R"(
layout(location = 0) out vec4 target;
#ifdef WORDS
layout(location = 6) uniform int part;
layout(binding = 2) uniform isampler2D limits;
uint words[39];
void put(int at, vec4 value) {
  uvec4 bits = floatBitsToUint(value);
  words[at] = bits.x;
  words[at + 1] = bits.y;
  words[at + 2] = bits.z;
  words[at + 3] = bits.w;
}
uint byte_at(int at) {
  return (words[at >> 2] >> uint(8 * (at & 3))) & 255u;
}
#else
layout(location = 1) uniform uint capacity;
struct Record {
  int x;
  int y;
  int primitive;
  float depth;
  float red;
  float green;
  float blue;
  float alpha;
#ifdef DETAILS
  vec4 coordinates;
  vec4 dx;
  vec4 dy;
  vec4 dx_fine;
  vec4 dy_fine;
  vec4 dx_coarse;
  vec4 dy_coarse;
#ifdef TEXTURES
  vec2 texture_coordinates;
  vec2 level_of_detail;
#endif
#endif
};
layout(std430, binding = 0) buffer Capture {
  uint count;
  uint unused[7];
  Record records[];
};
#endif
void main() {
  vec4 color = interpolated();
#ifdef DETAILS
  vec4 dx = dFdx(color);
  vec4 dy = dFdy(color);
#ifdef FINE_AND_COARSE
  vec4 dx_fine = dFdxFine(color);
  vec4 dy_fine = dFdyFine(color);
  vec4 dx_coarse = dFdxCoarse(color);
  vec4 dy_coarse = dFdyCoarse(color);
#else
  vec4 dx_fine = vec4(0.0);
  vec4 dy_fine = vec4(0.0);
  vec4 dx_coarse = vec4(0.0);
  vec4 dy_coarse = vec4(0.0);
#endif
#ifdef TEXTURES
  vec2 texture_coordinates = color.xy;
  vec2 level_of_detail = queried(color);
#endif
#endif
#ifdef TEXTURES
  color = looked_up(color);
#endif
#ifdef WORDS
  if (primitive_index >= texelFetch(limits, ivec2(gl_FragCoord.xy), 0).r) discard;
  words[0] = uint(primitive_index);
  words[1] = floatBitsToUint(gl_FragCoord.z);
  put(2, color);
#ifdef DETAILS
  put(6, gl_FragCoord);
  put(10, dx);
  put(14, dy);
  put(18, dx_fine);
  put(22, dy_fine);
  put(26, dx_coarse);
  put(30, dy_coarse);
#ifdef TEXTURES
  put(34, vec4(texture_coordinates, level_of_detail));
#endif
#endif
#ifdef SAMPLES
  words[38] = uint(gl_SampleMaskIn[0]);
#endif
  int at = 3 * part;
  uint tag = uint(primitive_index) % 255u + 1u;
  target = vec4(byte_at(at), byte_at(at + 1), byte_at(at + 2), tag) / 255.0;
#else
  uint slot = atomicAdd(count, 1u);
  if (slot < capacity) {
    records[slot].x = int(gl_FragCoord.x);
#ifdef SAMPLES
    records[slot].x |= gl_SampleMaskIn[0] << 16;
#endif
    records[slot].y = int(gl_FragCoord.y);
    records[slot].primitive = primitive_index;
    records[slot].depth = gl_FragCoord.z;
    records[slot].red = color.r;
    records[slot].green = color.g;
    records[slot].blue = color.b;
    records[slot].alpha = color.a;
#ifdef DETAILS
    records[slot].coordinates = gl_FragCoord;
    records[slot].dx = dx;
    records[slot].dy = dy;
    records[slot].dx_fine = dx_fine;
    records[slot].dy_fine = dy_fine;
    records[slot].dx_coarse = dx_coarse;
    records[slot].dy_coarse = dy_coarse;
#ifdef TEXTURES
    records[slot].texture_coordinates = texture_coordinates;
    records[slot].level_of_detail = level_of_detail;
#endif
#endif
  }
  target = color;
#endif
}
)";

}  // namespace edgecase::shaders
