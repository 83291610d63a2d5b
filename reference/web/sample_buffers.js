// SPDX-License-Identifier: MIT
// The depths and stencils of samples. WebGL has no call to read them, and no image of several samples
// that a shader could fetch.
//
// They are found by tests. A shader that runs for each sample marks those that pass: sample s writes
// 2^s, and the resolved mean, times the number of samples, is the sum of these marks. A stencil is
// tested bit by bit. A depth is searched bit by bit among the float32 numbers that a shader can
// write: the largest one that is stored as no more than what the sample holds. It must be stored as
// exactly that, which one more test shows. A buffer of one sample then tells which depth it is
// stored as, and a ramp of depths proves for each format that both kinds of buffer store alike.

const MARK = "target = vec4(float(1 << gl_SampleID), 0.0, 0.0, 0.0);";
const MARK_STENCILS = `
layout(location = 0) out vec4 target;
void main() { ${MARK} }
`;
const CANDIDATE = "uintBitsToFloat(texelFetch(candidates, ivec3(gl_FragCoord.xy, LAYER), 0).x)";
const WRITE_CANDIDATE = `
uniform highp usampler2DArray candidates;
uniform int layer;
layout(location = 0) out vec4 target;
void main() {
  gl_FragDepth = ${CANDIDATE.replace("LAYER", "layer")};
  target = vec4(0.0);
}
`;
const MARK_CANDIDATES = `
uniform highp usampler2DArray candidates;
layout(location = 0) out vec4 target;
void main() {
  gl_FragDepth = ${CANDIDATE.replace("LAYER", "gl_SampleID")};
  ${MARK}
}
`;
const WRITE_SAMPLE = `
uniform int sample_number;
layout(location = 0) out vec4 target;
void main() {
  target = vec4(0.0);
  gl_SampleMask[0] = 1 << sample_number;
}
`;
// A ramp of depths for one sample.
const WRITE_SAMPLE_RAMP = WRITE_DEPTH.replace("uniform", "uniform int sample_number;\nuniform")
  .replace("target =", "gl_SampleMask[0] = 1 << sample_number;\n  target =");
const BITS_OF_ONE = 0x3f800000;  // as float32
const PROVEN_SIZE = {width: 3, height: 2};

// Differs between samples in most bits.
const provenStencil = (sample, flipped) => ((0x5a + 37 * sample) & 0xff) ^ flipped;

class SampleBuffers {
  /** @param {SceneRenderer} renderer */
  constructor(renderer) {
    this.renderer = renderer;
    this.gl = renderer.gl;
    this.doubts = new Map();  // by formats and number of samples
  }

  /** Why the target's depths or stencils cannot be told; empty if they can. @param {Target} target */
  doubtOf(target) {
    if (!target.depth && !target.stencil) return "";
    const one = {...target, samples: 1};
    const doubt = this.renderer.buffers.doubtOf(one);
    if (doubt) return doubt;
    const key = [target.depth, target.stencil, target.samples].join(" ");
    if (!this.doubts.has(key)) this.doubts.set(key, this.prove(target));
    return this.doubts.get(key);
  }

  /** @param {Target} target */
  prove(target) {
    const formats = [target.depth, target.stencil].filter(Boolean).join(" and ");
    const problem = (target.stencil ? this.proveStencils(target) : "") ||
      (target.depth ? this.proveDepths(target) : "");
    return problem && `asked for ${formats} of ${target.samples} samples, ${problem}`;
  }

  /** @param {Target} target @param {(probe: SampledFramebuffer) => string} use */
  withProbe(target, use) {
    const depth = new Depth(this.gl, target);
    const probe = new SampledFramebuffer(this.gl, [this.gl.R32F], target, depth);
    const problem = probe.complete ? use(probe) : "this device makes no framebuffer";
    probe.free();
    depth.free();
    return problem;
  }

  /** @param {Target} asked */
  proveDepths(asked) {
    const {gl} = this;
    const {buffers} = this.renderer;
    const target = {...asked, ...RAMP};
    return this.withProbe(target, (probe) => {
      const set = new TargetSet(gl, {...target, samples: 1});
      const expected = Array.from({length: target.samples}, (_, sample) => {
        for (const framebuffer of [probe, set.color]) {
          framebuffer.bind();
          resetState(gl);
          gl.enable(gl.DEPTH_TEST);
          gl.depthFunc(gl.ALWAYS);
          buffers.cover(framebuffer, framebuffer === probe ? WRITE_SAMPLE_RAMP : WRITE_DEPTH,
            (program) => {
              program.float("steps", RAMP.width * RAMP.height * (1 + sample / 8) + 0.7);
              program.integer("sample_number", sample);
            }, framebuffer === probe);
        }
        return buffers.depths(set);
      }).flat();
      const found = this.depths(target, probe, set);
      set.free();
      return found && found.every((depth, i) => depth === expected[i]) ? ""
        : "this device makes a buffer whose samples do not hold what a buffer without them holds";
    });
  }

  /** @param {Target} asked */
  proveStencils(asked) {
    const {gl} = this;
    const target = {...asked, ...PROVEN_SIZE};
    return this.withProbe(target, (probe) => {
      for (const flipped of [0, 0xff]) {
        probe.bind();
        clearAll(gl, target, [0, 0, 0, 0]);
        gl.enable(gl.STENCIL_TEST);
        gl.stencilOp(gl.KEEP, gl.KEEP, gl.REPLACE);
        for (let sample = 0; sample < target.samples; ++sample) {
          gl.stencilFunc(gl.ALWAYS, provenStencil(sample, flipped), 0xff);
          this.renderer.buffers.cover(probe, WRITE_SAMPLE,
            (program) => program.integer("sample_number", sample), true);
        }
        const area = target.width * target.height;
        if (this.stencils(target, probe).some(
          (stencil, i) => stencil !== provenStencil(Math.floor(i / area), flipped)))
          return "this device makes a buffer that does not hold the stencils written to its samples";
      }
      return "";
    });
  }

  /** For each pixel, the samples that pass the tests that are set, as bits.
   * @param {SampledFramebuffer} probe with one image, R32F */
  marks(probe, source, prepare) {
    const gl = this.gl;
    gl.disable(gl.BLEND);
    probe.bind();
    gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
    this.renderer.buffers.cover(probe, source, prepare, true);
    return probe.sums(0);
  }

  /** Row by row from the bottom, all of sample 0 first.
   * @param {Target} target @param {SampledFramebuffer} probe */
  stencils(target, probe) {
    const gl = this.gl;
    const area = target.width * target.height;
    const stencils = Array(area * target.samples).fill(0);
    for (let bit = 1; bit < 256; bit *= 2) {
      resetState(gl);
      gl.enable(gl.STENCIL_TEST);
      gl.stencilOp(gl.KEEP, gl.KEEP, gl.KEEP);
      gl.stencilFunc(gl.EQUAL, bit, bit);
      const marks = this.marks(probe, MARK_STENCILS, () => {});
      for (let i = 0; i < stencils.length; ++i)
        if (marks[i % area] & (1 << Math.floor(i / area))) stencils[i] += bit;
    }
    resetState(gl);
    return stencils;
  }

  /** In the same order, 0 to 1; null if one is none that a shader can write.
   * @param {Target} target @param {SampledFramebuffer} probe
   * @param {TargetSet} single one of the same size and formats, without samples */
  depths(target, probe, single) {
    const gl = this.gl;
    const {width, height, samples} = target;
    const area = width * height;
    const candidates = this.makeCandidates(width, height, samples);
    const passes = (bits, test) => this.passing(probe, candidates, bits, test, area);
    const found = new Uint32Array(area * samples);
    for (let bit = 1 << 29; bit > 0; bit >>= 1) {
      const tried = found.map((low) => Math.min(low | bit, BITS_OF_ONE));
      const passed = passes(tried, gl.LEQUAL);
      for (let i = 0; i < found.length; ++i)
        if (passed(i) && (found[i] | bit) <= BITS_OF_ONE) found[i] |= bit;
    }
    const holds = passes(found, gl.EQUAL);
    const depths = found.every((_, i) => holds(i))
      ? this.storedDepths(single, candidates, samples) : null;
    gl.deleteTexture(candidates);
    return depths;
  }

  makeCandidates(width, height, samples) {
    const gl = this.gl;
    const candidates = gl.createTexture();
    gl.activeTexture(gl.TEXTURE0 + ABOVE_UNIT);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, candidates);
    gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, gl.R32UI, width, height, samples);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
      gl.texParameteri(gl.TEXTURE_2D_ARRAY, filter, gl.NEAREST);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, null);
    return candidates;
  }

  /** Which samples would let a fragment of such a depth pass: a function of their index.
   * @param {SampledFramebuffer} probe @param {Uint32Array} bits of float32 numbers */
  passing(probe, candidates, bits, test, area) {
    const gl = this.gl;
    const {width, height} = probe.resolved;
    gl.activeTexture(gl.TEXTURE0 + ABOVE_UNIT);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, candidates);
    gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, 0, width, height, bits.length / area,
      gl.RED_INTEGER, gl.UNSIGNED_INT, bits);
    resetState(gl);
    gl.enable(gl.DEPTH_TEST);
    gl.depthMask(false);
    gl.depthFunc(test);
    const marks = this.marks(probe, MARK_CANDIDATES,
      (program) => program.integer("candidates", ABOVE_UNIT));
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, null);
    return (i) => (marks[i % area] & (1 << Math.floor(i / area))) !== 0;
  }

  /** What a buffer of one sample stores them as. @param {TargetSet} single */
  storedDepths(single, candidates, samples) {
    const gl = this.gl;
    /** @type {number[]} */
    const depths = [];
    for (let layer = 0; layer < samples; ++layer) {
      resetState(gl);
      gl.enable(gl.DEPTH_TEST);
      gl.depthFunc(gl.ALWAYS);
      this.renderer.buffers.cover(single.color, WRITE_CANDIDATE, (program) => {
        gl.activeTexture(gl.TEXTURE0 + ABOVE_UNIT);
        gl.bindTexture(gl.TEXTURE_2D_ARRAY, candidates);
        program.integer("candidates", ABOVE_UNIT);
        program.integer("layer", layer);
      });
      gl.bindTexture(gl.TEXTURE_2D_ARRAY, null);
      for (const depth of this.renderer.buffers.depths(single)) depths.push(depth);
    }
    resetState(gl);
    return depths;
  }
}
