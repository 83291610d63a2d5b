// SPDX-License-Identifier: MIT
// The fragments of a scene on a target of several samples.
//
// WebGL has no images of several samples that a shader could fetch: it resolves them. So each pass
// writes one sample alone, by gl_SampleMask, over zeros; the mean of all samples, times their number,
// is what that one holds, exactly, since their number is a power of two. Passes peel as in
// capture.js, and what the samples of one invocation tell must agree.

const POSITION_SHADER = `
uniform int sample_number;
layout(location = 0) out vec4 target;
void main() {
  target = vec4(gl_SamplePosition, 1.0, 0.0);
  gl_SampleMask[0] = gl_SampleID == sample_number ? 1 << sample_number : 0;
}
`;

/** A framebuffer of several samples, and one that it is resolved into. */
class SampledFramebuffer {
  /** @param {WebGL2RenderingContext} gl @param {number[]} formats @param {Target} target */
  constructor(gl, formats, {samples, width, height}) {
    this.gl = gl;
    this.samples = samples;
    this.images = formats.map((format) => {
      const image = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, image);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, width, height);
      return image;
    });
    this.name = gl.createFramebuffer();
    this.bind();
    this.buffers = this.images.map((image, i) => {
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.RENDERBUFFER, image);
      return gl.COLOR_ATTACHMENT0 + i;
    });
    gl.drawBuffers(this.buffers);
    this.complete = gl.checkFramebufferStatus(gl.FRAMEBUFFER) === gl.FRAMEBUFFER_COMPLETE &&
      gl.getParameter(gl.SAMPLES) === samples;
    this.resolved = new Framebuffer(gl, formats, width, height);
  }

  bind() {
    this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, this.name);
  }

  resolve() {
    const gl = this.gl;
    const {width, height, name} = this.resolved;
    resetState(gl);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.name);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, name);
    for (const buffer of this.buffers) {
      gl.readBuffer(buffer);
      gl.drawBuffers(this.buffers.map((other) => (other === buffer ? other : gl.NONE)));
      gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    }
    gl.drawBuffers(this.buffers);
    return this.resolved;
  }

  free() {
    for (const image of this.images) this.gl.deleteRenderbuffer(image);
    this.gl.deleteFramebuffer(this.name);
    this.resolved.free();
  }
}

class SampleCapture {
  /** @param {SceneRenderer} renderer */
  constructor(renderer) {
    this.renderer = renderer;
    this.gl = renderer.gl;
    this.key = "";
    /** @type {{color: SampledFramebuffer, pair: SampledFramebuffer[]}} */
    this.kept = null;
    this.positions = new Map();
  }

  /** @param {Target} target */
  find(target) {
    const key = [target.width, target.height, target.samples].join(" ");
    if (this.key === key) return this.kept;
    const gl = this.gl;
    if (this.kept) for (const old of [this.kept.color, ...this.kept.pair]) old.free();
    const floats = [gl.RGBA32F, gl.RGBA32F];
    this.kept = {color: new SampledFramebuffer(gl, [gl.RGBA8], target),
      pair: [0, 1].map(() => new SampledFramebuffer(gl, floats, target))};
    this.key = key;
    if (![this.kept.color, ...this.kept.pair].every((framebuffer) => framebuffer.complete)) {
      this.key = "";
      throw new Doubt(`this device has no ${target.width}x${target.height} framebuffer of ` +
        `${target.samples} samples`);
    }
    return this.kept;
  }

  /** @param {Scene} scene */
  render(scene) {
    const gl = this.gl;
    const {color, pair} = this.find(scene.target);
    color.bind();
    clearAll(gl, scene.target, scene.target.clear);
    this.renderer.drawAll(scene, "color", PIXELS, false);
    const pixels = [...color.resolve().bytes()];
    const fragments = this.fragments(scene, pair);
    return {pixels, fragments, sample_positions: this.findPositions(scene.target.samples)};
  }

  /** @param {Scene} scene @param {SampledFramebuffer[]} pair */
  fragments(scene, pair) {
    /** @type {Map<string, {fragment: Fragment, told: number}>} */
    const found = new Map();
    for (let sample = 0; sample < scene.target.samples; ++sample)
      for (let layer = 0; ; ++layer) {
        this.drawLayer(scene, pair[layer % 2], layer > 0 ? pair[(layer + 1) % 2] : null, sample);
        if (this.readLayer(scene, pair[layer % 2].resolved, sample, found) === 0) break;
      }
    return [...found.values()].map(({fragment, told}) => {
      if (told !== fragment.coverage)
        throw new Doubt(`the fragment at pixel (${fragment.x}, ${fragment.y}) covers the samples ` +
          `${fragment.coverage}, and those that it writes are ${told}`);
      return fragment;
    });
  }

  /** @param {Scene} scene @param {SampledFramebuffer} into @param {SampledFramebuffer} above */
  drawLayer(scene, into, above, sample) {
    const gl = this.gl;
    into.bind();
    resetState(gl);
    for (const buffer of [0, 1]) gl.clearBufferfv(gl.COLOR, buffer, [0, 0, 0, 0]);
    gl.activeTexture(gl.TEXTURE0 + ABOVE_UNIT);
    gl.bindTexture(gl.TEXTURE_2D, above && above.resolved.images[0]);
    this.renderer.drawAll(scene, "samples", ALL, false, (program) => {
      program.integer("above", ABOVE_UNIT);
      program.integer("peels", above ? 1 : 0);
      program.integer("sample_number", sample);
      program.float("samples", scene.target.samples);
    });
    gl.activeTexture(gl.TEXTURE0 + ABOVE_UNIT);
    gl.bindTexture(gl.TEXTURE_2D, null);
    into.resolve();
  }

  /** Returns how many fragments it has read. @param {Scene} scene @param {Framebuffer} layer */
  readLayer(scene, layer, sample, found) {
    const {width, height, samples} = scene.target;
    const places = layer.floats(0).map((number) => number * samples);
    const colors = layer.floats(1).map((number) => number * samples);
    const primitives = drawsByPrimitive(scene).length;
    let count = 0;
    for (let i = 0; i < width * height; ++i) {
      const [number, coverage, depth] = places.subarray(4 * i, 4 * i + 3);
      if (number === 0) continue;
      const [x, y] = [i % width, Math.floor(i / width)];
      if (number < 2 || number !== Math.floor(number) || number - 2 >= primitives)
        throw new Doubt(`the fragment at pixel (${x}, ${y}) has the number of no primitive`);
      ++count;
      const key = `${i} ${number} ${coverage}`;
      const known = found.get(key);
      const fragment = {x, y, primitive: number - 2, coverage, depth,
        color: [...colors.subarray(4 * i, 4 * i + 4)]};
      if (!known) found.set(key, {fragment, told: 2 ** sample});
      else if (JSON.stringify(known.fragment) === JSON.stringify(fragment)) known.told += 2 ** sample;
      else throw new Doubt(`the samples of the fragment at pixel (${x}, ${y}) tell different values`);
    }
    return count;
  }

  /** Where the device says that its samples are. @param {number} samples */
  findPositions(samples) {
    if (!this.positions.has(samples)) {
      const gl = this.gl;
      const one = new SampledFramebuffer(gl, [gl.RGBA32F], /** @type {Target} */ (
        {samples, width: 1, height: 1}));
      const positions = Array.from({length: samples}, (_, sample) => {
        one.bind();
        resetState(gl);
        gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
        gl.bindVertexArray(null);
        gl.viewport(0, 0, 1, 1);
        this.renderer.programs.everywhere(POSITION_SHADER, true).integer("sample_number", sample);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        return [...one.resolve().floats().map((number) => number * samples)];
      });
      one.free();
      this.positions.set(samples, positions.every((place) => place[2] === 1)
        ? positions.map((place) => place.slice(0, 2)) : undefined);
    }
    return this.positions.get(samples);
  }
}
