// SPDX-License-Identifier: MIT
// The contents of depth and stencil buffers, which WebGL has no call to read.

const FETCH_DEPTH = `
uniform highp sampler2D depths;
layout(location = 0) out uvec4 target;
void main() {
  target = uvec4(floatBitsToUint(texelFetch(depths, ivec2(gl_FragCoord.xy), 0).x), 0u, 0u, 0u);
}
`;
const WRITE_DEPTH = `
uniform float steps;
layout(location = 0) out vec4 target;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  gl_FragDepth = steps == 0.0 ? 1.0 : (float(at.y * 256 + at.x) + 0.37) / steps;
  target = vec4(1.0);
}
`;
const WRITE_COLOR = `
uniform float value;
layout(location = 0) out vec4 target;
void main() { target = vec4(value, 0.0, 0.0, 0.0); }
`;
const RAMP = {width: 256, height: 64};

const FETCHES = {
  quotient: (integer, largest) => Math.fround(integer / largest),
  product: (integer, largest) => Math.fround(integer * Math.fround(1 / largest)),
};

// The integer whose fetch gives this number; nothing if there is none.
function integerOf(fetched, largest, fetch) {
  const nearest = Math.round(fetched * largest);
  return [nearest, nearest + 1, nearest - 1].find((integer) =>
    integer >= 0 && integer <= largest && FETCHES[fetch](integer, largest) === fetched);
}

class BufferReader {
  /** @param {WebGL2RenderingContext} gl @param {Programs} programs */
  constructor(gl, programs) {
    this.gl = gl;
    this.programs = programs;
    this.fetches = new Map();  // by formats: how depths are fetched, or a sentence on why not
  }

  /** Draws over a whole framebuffer. @param {Framebuffer|SampledFramebuffer} framebuffer
   * @param {boolean} samples does the shader use those of its pixel? */
  cover(framebuffer, source, prepare = (/** @type {Program} */ program) => {}, samples = false) {
    const gl = this.gl;
    gl.bindVertexArray(null);
    framebuffer.bind();
    gl.viewport(0, 0, framebuffer.width, framebuffer.height);
    prepare(this.programs.everywhere(source, samples));
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /** Float32 numbers as the shader fetches them. @param {Depth} depth */
  fetched(depth, width, height) {
    const gl = this.gl;
    const words = new Framebuffer(gl, [gl.RGBA32UI], width, height);
    resetState(gl);
    this.cover(words, FETCH_DEPTH, (program) => {
      gl.activeTexture(gl.TEXTURE0 + ABOVE_UNIT);
      gl.bindTexture(gl.TEXTURE_2D, depth.texture);
      program.integer("depths", ABOVE_UNIT);
    });
    gl.bindTexture(gl.TEXTURE_2D, null);
    const bits = words.words(0).filter((_, i) => i % 4 === 0);
    words.free();
    return new Float32Array(bits.buffer);
  }

  /** Finds how a format is fetched, by a ramp of depths that lie between its integers.
   * @param {Target} target */
  findFetch(target) {
    const gl = this.gl;
    const set = new TargetSet(gl, {...target, ...RAMP});
    let found = "";
    if (set.color.complete) {
      clearAll(gl, target, [0, 0, 0, 0]);
      gl.enable(gl.DEPTH_TEST);
      gl.depthFunc(gl.ALWAYS);
      this.cover(set.color, WRITE_DEPTH,
        (program) => program.float("steps", RAMP.width * RAMP.height + 0.7));
      const ramp = [...this.fetched(set.depth, RAMP.width, RAMP.height)];
      const largest = 2 ** DEPTH_BITS[target.depth] - 1;
      found = Object.keys(FETCHES).find(
        (fetch) => ramp.every((number) => integerOf(number, largest, fetch) !== undefined)) || "";
    }
    set.free();
    return found;
  }

  /** Why the target's depths cannot be read; empty if they can. @param {Target} target */
  doubtOf(target) {
    if (!target.depth || target.depth === "depth32f") return "";
    const formats = [target.depth, target.stencil].filter(Boolean).join(" and ");
    if (!this.fetches.has(formats)) this.fetches.set(formats, this.findFetch(target));
    return this.fetches.get(formats) ? ""
      : `asked for ${formats}, this device makes another buffer: its depths are no integers`;
  }

  /** The depth buffer, 0 to 1. @param {TargetSet} set */
  depths(set) {
    const {target} = set;
    const fetched = [...this.fetched(set.depth, target.width, target.height)];
    if (target.depth === "depth32f") return fetched;
    const fetch = this.fetches.get([target.depth, target.stencil].filter(Boolean).join(" and "));
    const largest = 2 ** DEPTH_BITS[target.depth] - 1;
    const integers = fetched.map((number) => integerOf(number, largest, fetch));
    if (integers.includes(undefined)) throw new Doubt(`a depth is none that ${target.depth} holds`);
    // The two largest integers may give the same number.
    if (FETCHES[fetch](largest - 1, largest) === 1 && integers.includes(largest)) {
      const isLargest = this.largestDepths(set);
      integers.forEach((integer, i) => {
        if (integer >= largest - 1) integers[i] = isLargest[4 * i] ? largest : largest - 1;
      });
    }
    return integers.map((integer) => integer / largest);
  }

  // For each pixel, whether its depth is 1. The colours are lost.
  largestDepths(set) {
    const gl = this.gl;
    resetState(gl);
    set.color.bind();
    gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.EQUAL);
    gl.depthMask(false);
    this.cover(set.color, WRITE_DEPTH, (program) => program.float("steps", 0));
    return set.color.bytes();
  }

  /** The stencil buffer, by a test of each bit. The colours are lost. @param {TargetSet} set */
  stencils(set) {
    const gl = this.gl;
    resetState(gl);
    set.color.bind();
    gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
    gl.enable(gl.STENCIL_TEST);
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.KEEP);
    gl.enable(gl.BLEND);
    gl.blendEquation(gl.FUNC_ADD);
    gl.blendFunc(gl.ONE, gl.ONE);
    for (let bit = 1; bit < 256; bit *= 2) {
      gl.stencilFunc(gl.EQUAL, bit, bit);
      this.cover(set.color, WRITE_COLOR, (program) => program.float("value", bit / 255));
    }
    resetState(gl);
    return [...set.color.bytes().filter((_, i) => i % 4 === 0)];
  }
}
