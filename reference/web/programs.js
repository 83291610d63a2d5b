// SPDX-License-Identifier: MIT
// The shaders that draw scenes, and programs of them, compiled when first needed and kept.
//
// WebGL 2 has no storage buffers: a fragment is told by what its shader writes into images of
// unsigned integers, the bits of its numbers unchanged.

const VERTEX_SHADER = `
layout(location = 0) in vec4 position;
layout(location = 1) in vec4 color;
layout(location = 2) in int primitive;
flat out vec4 flat_color;
smooth AT out vec4 smooth_color;
NOPERSPECTIVE AT out vec4 noperspective_color;
flat out int primitive_index;
uniform float point_size;
void main() {
  gl_Position = position;
  gl_PointSize = point_size;
  flat_color = color;
  smooth_color = color;
  noperspective_color = color;
  primitive_index = primitive;
}
`;

// One triangle, of three vertices without attributes, that covers the viewport.
const EVERYWHERE = `
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
`;

const INPUTS = `
flat in vec4 flat_color;
smooth AT in vec4 smooth_color;
NOPERSPECTIVE AT in vec4 noperspective_color;
flat in int primitive_index;
uniform int interpolation;
uniform float lookup_value;
uniform vec4 gradients;
uniform sampler2D image;
uniform int sample_mask;
vec4 own_color() {
  return interpolation == 0 ? flat_color : (interpolation == 1 ? smooth_color : noperspective_color);
}
`;

const COLOR_SHADER = `${INPUTS}
layout(location = 0) out vec4 target;
void main() {
  vec4 color = own_color();
  target = LOOKUP;
#ifdef MASKED
  gl_SampleMask[0] = sample_mask;
#endif
}
`;

// `only`: the one primitive that counts, or -1.
const COUNT_SHADER = `${INPUTS}
uniform float hit_step;
uniform int only;
layout(location = 0) out vec4 target;
void main() {
  if (only >= 0 && primitive_index != only) discard;
  target = vec4(hit_step, 0.0, 0.0, 0.0);
}
`;

// The same for one sample of a multisampled target. By the colour's alpha, alpha to coverage decides
// which samples are hit.
const SAMPLE_COUNT_SHADER = `${INPUTS}
uniform int sample_number;
layout(location = 0) out vec4 target;
void main() {
  target = vec4(1.0, 0.0, 0.0, own_color().a);
  gl_SampleMask[0] = sample_mask & (1 << sample_number);
}
`;

// Tells the last fragment of each pixel or, if `peels`, the last one of a primitive with a lower
// number than that in `above`. A primitive's number is written plus 2, since 0 is no fragment and 1
// one without a primitive.
const CAPTURE_SHADER = `${INPUTS}
uniform bool peels;
uniform highp usampler2D above;
layout(location = 0) out uvec4 place;
layout(location = 1) out uvec4 colors;
#ifdef DETAILS
layout(location = 2) out uvec4 coordinates;
layout(location = 3) out uvec4 dx;
layout(location = 4) out uvec4 dy;
#endif
#ifdef LEVELS
layout(location = 5) out uvec4 levels;
#endif
#ifdef MEASURED
${MEASURE}
#endif
void main() {
  vec4 color = own_color();
  uint number = uint(primitive_index + 2);
  place = uvec4(number, floatBitsToUint(gl_FragCoord.z), floatBitsToUint(color.xy));
#ifdef DETAILS
  coordinates = floatBitsToUint(gl_FragCoord);
  dx = floatBitsToUint(dFdx(color));
  dy = floatBitsToUint(dFdy(color));
#endif
#ifdef LEVELS
  levels = uvec4(0u);
#endif
#ifdef MEASURED
  levels = measured(color.xy);
#endif
  colors = floatBitsToUint(LOOKUP);
  if (peels && number >= texelFetch(above, ivec2(gl_FragCoord.xy), 0).x) discard;
}
`;

// The same for one sample of a multisampled target, whose images can be floats alone, since those
// are what resolving takes a mean of. All other samples stay 0.
const SAMPLE_CAPTURE_SHADER = `${INPUTS}
uniform bool peels;
uniform highp sampler2D above;
uniform int sample_number;
uniform float samples;
layout(location = 0) out vec4 place;
layout(location = 1) out vec4 colors;
#ifdef DETAILS
layout(location = 2) out vec4 coordinates;
#endif
void main() {
  vec4 color = own_color();
  float number = float(primitive_index + 2);
  place = vec4(number, float(gl_SampleMaskIn[0] & sample_mask), gl_FragCoord.z, 0.0);
  colors = color;
#ifdef DETAILS
  coordinates = gl_FragCoord;
#endif
  if (peels && number >= samples * texelFetch(above, ivec2(gl_FragCoord.xy), 0).x) discard;
  gl_SampleMask[0] = sample_mask & (1 << sample_number);
}
`;

const LOOKUPS = {
  none: "color",
  implicit: "texture(image, color.xy)",
  bias: "texture(image, color.xy, lookup_value)",
  lod: "textureLod(image, color.xy, lookup_value)",
  gradients: "textureGrad(image, color.xy, gradients.xy, gradients.zw)",
};
const LOCATIONS = {center: "", centroid: "centroid", sample: "sample"};

class ProgramError extends Error {}

/** How often a shader runs at least, of a primitive's pixel. @param {Draw} draw */
function leastInvocations({multisampling: use}, samples) {
  if (use.location === "sample") return samples;
  return Math.max(1, Math.ceil((use.min_sample_shading || 0) * samples));
}

// Attributes at the samples make a shader run for each of them, as glMinSampleShading would.
/** @param {Draw} draw @param {number} samples of the target */
function attributeLocation(draw, samples) {
  if (samples === 1) return "center";
  return leastInvocations(draw, samples) > 1 ? "sample" : draw.multisampling.location;
}

/** Does a draw's mask permit each sample? @param {Draw} draw @param {number} samples */
function permitsAll({multisampling: use}, samples) {
  const all = 2 ** samples - 1;
  return samples === 1 || (use.mask & all) === all;
}

class Programs {
  /** @param {WebGL2RenderingContext} gl @param {Limits} limits */
  constructor(gl, limits) {
    this.gl = gl;
    this.limits = limits;
    this.has = limits.has;
    /** @type {Map<string, Program>} */
    this.kept = new Map();
  }

  head(fragment, samples) {
    const required = [];
    if (this.has.NV_shader_noperspective_interpolation)
      required.push("GL_NV_shader_noperspective_interpolation");
    if (samples) required.push("GL_OES_shader_multisample_interpolation");
    if (samples && fragment) required.push("GL_OES_sample_variables");
    return "#version 300 es\n" +
      required.map((name) => `#extension ${name} : require\n`).join("") +
      "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n" +
      `#define NOPERSPECTIVE ${
        this.has.NV_shader_noperspective_interpolation ? "noperspective" : "smooth"}\n`;
  }

  /**
   * @param {string} kind color, count, capture, details, levels (details and those), samples,
   *   sample details or sample count
   * @param {Draw} draw whose lookup and location of attributes the program has
   * @param {number} samples of the target
   */
  forDraw(kind, draw, samples) {
    const lookup = draw.texture && kind !== "count" ? draw.texture.lookup.kind : "none";
    const location = attributeLocation(draw, samples);
    const isMeasured = kind === "levels" && tellsLevels(draw, this.limits);
    const defined = [...(kind.endsWith("details") ? ["DETAILS"] : []),
      ...(kind === "levels" ? ["DETAILS", "LEVELS"] : []),
      ...(isMeasured ? ["MEASURED"] : []),
      ...(permitsAll(draw, samples) ? [] : ["MASKED"])];
    return this.find([kind, lookup, location, samples > 1, ...defined].join(" "), () => {
      const at = `#define AT ${LOCATIONS[location]}\n`;
      const source = {"color": COLOR_SHADER, "count": COUNT_SHADER, "capture": CAPTURE_SHADER,
        "details": CAPTURE_SHADER, "levels": CAPTURE_SHADER, "samples": SAMPLE_CAPTURE_SHADER,
        "sample details": SAMPLE_CAPTURE_SHADER, "sample count": SAMPLE_COUNT_SHADER}[kind];
      const definitions = defined.map((name) => `#define ${name}\n`).join("");
      return [this.head(false, samples > 1) + at + VERTEX_SHADER,
        this.head(true, samples > 1) + at + definitions +
          `#define LOOKUP ${LOOKUPS[lookup]}\n` + source];
    });
  }

  /** A program that runs once for every pixel of the viewport. */
  everywhere(fragment, samples = false) {
    return this.find(fragment,
      () => [this.head(false, false) + EVERYWHERE, this.head(true, samples) + fragment]);
  }

  /** @param {() => string[]} sources of its vertex and its fragment shader */
  find(key, sources) {
    let program = this.kept.get(key);
    if (!program) {
      const [vertex, fragment] = sources();
      program = new Program(this.gl, vertex, fragment);
      this.kept.set(key, program);
    }
    program.use();
    return program;
  }
}

class Program {
  /** @param {WebGL2RenderingContext} gl @throws {ProgramError} */
  constructor(gl, vertex, fragment) {
    this.gl = gl;
    this.program = gl.createProgram();
    for (const [stage, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(stage);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(this.program, shader);
    }
    gl.linkProgram(this.program);
    if (!gl.getProgramParameter(this.program, gl.LINK_STATUS) && !gl.isContextLost())
      throw new ProgramError("this device refuses our shaders: " + this.log());
    this.places = new Map();
  }

  log() {
    const shaders = this.gl.getAttachedShaders(this.program) || [];
    return [...shaders.map((shader) => this.gl.getShaderInfoLog(shader)),
      this.gl.getProgramInfoLog(this.program)].filter(Boolean).join(" ").slice(0, 500);
  }

  use() {
    this.gl.useProgram(this.program);
  }

  place(name) {
    if (!this.places.has(name))
      this.places.set(name, this.gl.getUniformLocation(this.program, name));
    return this.places.get(name);
  }

  // Uniforms that a program does not use are ignored.
  float(name, value) {
    this.gl.uniform1f(this.place(name), value);
  }

  integer(name, value) {
    this.gl.uniform1i(this.place(name), value);
  }

  vector(name, values) {
    this.gl.uniform4fv(this.place(name), values);
  }
}
