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
  /** @param {WebGL2RenderingContext} gl @param {number[]} formats @param {Target} target
   * @param {Depth} depth of as many samples, or null */
  constructor(gl, formats, {samples, width, height}, depth = null) {
    this.gl = gl;
    this.samples = samples;
    this.width = width;
    this.height = height;
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
    if (depth) depth.attach();
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

  /** What all samples of a pixel hold together, in one channel. */
  sums(channel) {
    return this.resolve().floats().filter((_, i) => i % 4 === channel)
      .map((mean) => mean * this.samples);
  }

  free() {
    for (const image of this.images) this.gl.deleteRenderbuffer(image);
    this.gl.deleteFramebuffer(this.name);
    this.resolved.free();
  }
}

// Without alpha to coverage, a sample has as many hits as fragments that cover it, and no more where
// tests may drop some.
/** @param {Scene} scene @param {Rendering} rendering */
function refuseContradiction(scene, {hits, fragments}) {
  if (scene.draws.some((draw) => draw.multisampling.alpha_to_coverage)) return;
  const {width, height, samples} = scene.target;
  const covering = Array(hits.length).fill(0);
  for (const {x, y, coverage} of fragments)
    for (let sample = 0; sample < samples; ++sample)
      covering[(sample * height + y) * width + x] += (coverage >> sample) & 1;
  const mayFail = hasFragmentOperations(scene);
  const i = hits.findIndex((count, at) => (mayFail ? count > covering[at] : count !== covering[at]));
  if (i < 0) return;
  throw new Doubt(`sample ${Math.floor(i / (width * height))} of pixel (${i % width}, ${
    Math.floor(i / width) % height}) has ${hits[i]} hits, and ${covering[i]} fragments that cover it`);
}

/** @param {Scene} scene */
const tellsCoordinates = (scene) => (scene.details || []).includes("coordinates");

class SampleCapture {
  /** @param {SceneRenderer} renderer */
  constructor(renderer) {
    this.renderer = renderer;
    this.gl = renderer.gl;
    this.key = "";
    /** @type {{depth: Depth, color: SampledFramebuffer, sums: SampledFramebuffer,
     *   pair: SampledFramebuffer[]}} */
    this.kept = null;
    this.buffers = new SampleBuffers(renderer);
    this.positions = new Map();
  }

  /** @param {Target} target @param {boolean} detailed are coordinates told? */
  find(target, detailed) {
    const key = [target.width, target.height, target.samples, target.depth, target.stencil,
      detailed].join(" ");
    if (this.key === key) return this.kept;
    this.free();
    const gl = this.gl;
    const depth = target.depth || target.stencil ? new Depth(gl, target) : null;
    const made = (...formats) => new SampledFramebuffer(gl, formats, target, depth);
    this.kept = {depth, color: made(gl.RGBA8), sums: made(gl.R32F),
      pair: [0, 1].map(() => made(...Array(detailed ? 3 : 2).fill(gl.RGBA32F)))};
    if (!this.framebuffers().every((framebuffer) => framebuffer.complete))
      throw new Doubt(`this device has no ${target.width}x${target.height} framebuffer of ` +
        `${target.samples} samples` +
        (depth ? " with the asked depth or stencil buffer" : ""));
    this.key = key;
    return this.kept;
  }

  framebuffers() {
    return [this.kept.color, this.kept.sums, ...this.kept.pair];
  }

  free() {
    this.key = "";
    if (!this.kept) return;
    for (const framebuffer of this.framebuffers()) framebuffer.free();
    if (this.kept.depth) this.kept.depth.free();
  }

  /** @param {Scene} scene */
  render(scene) {
    const {target} = scene;
    const doubt = this.buffers.doubtOf(target);
    if (doubt) throw new Doubt(doubt);
    const {color, sums, pair} = this.find(target, tellsCoordinates(scene));
    color.bind();
    clearAll(this.gl, target, target.clear);
    this.renderer.drawAll(scene, "color", PIXELS, false);
    /** @type {Rendering} */
    const rendering = {pixels: [...color.resolve().bytes()]};
    if (target.depth) rendering.depths = this.depths(target, sums);
    if (target.stencil) rendering.stencils = this.buffers.stencils(target, sums);
    rendering.fragments = this.fragments(scene, pair);
    rendering.hits = this.hits(scene, sums);
    refuseContradiction(scene, rendering);
    rendering.sample_positions = this.findPositions(target.samples);
    return rendering;
  }

  /** @param {Target} target @param {SampledFramebuffer} sums */
  depths(target, sums) {
    const single = this.renderer.targets.find({...target, samples: 1});
    const depths = this.buffers.depths(target, sums, single);
    if (!depths) throw new Doubt(`a sample's depth is none that a shader writes to ${target.depth}`);
    return depths;
  }

  /** Fragments that are written to each sample, all of sample 0 first.
   * @param {Scene} scene @param {SampledFramebuffer} sums */
  hits(scene, sums) {
    /** @type {number[]} */
    const hits = [];
    for (let sample = 0; sample < scene.target.samples; ++sample) {
      sums.bind();
      clearAll(this.gl, scene.target, [0, 0, 0, 0]);
      this.renderer.drawAll(scene, "sample count", HITS, true,
        (program) => program.integer("sample_number", sample));
      for (const count of sums.sums(0)) hits.push(count);
    }
    return hits;
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
    into.images.forEach((_, buffer) => gl.clearBufferfv(gl.COLOR, buffer, [0, 0, 0, 0]));
    gl.activeTexture(gl.TEXTURE0 + ABOVE_UNIT);
    gl.bindTexture(gl.TEXTURE_2D, above && above.resolved.images[0]);
    const kind = tellsCoordinates(scene) ? "sample details" : "samples";
    this.renderer.drawAll(scene, kind, ALL, false, (program) => {
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
    const [places, colors, coordinates] = layer.images.map(
      (_, buffer) => layer.floats(buffer).map((number) => number * samples));
    const at = (numbers, i) => [...numbers.subarray(4 * i, 4 * i + 4)];
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
      /** @type {Fragment} */
      const fragment = {x, y, primitive: number - 2, coverage, depth, color: at(colors, i)};
      if (coordinates) fragment.coordinates = at(coordinates, i);
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
