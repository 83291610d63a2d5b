// SPDX-License-Identifier: MIT
// The fragments of a scene on a target of one sample.
//
// A pass tells one fragment for each pixel: of what is drawn the last stays. Where several primitives
// meet, further passes peel: each drops whatever is not below the fragment found last. How many
// fragments there are is counted apart, by blending; what a pixel has more of them than were found
// is fragments that one primitive has twice.

/**
 * @typedef {{x: number, y: number, primitive: number, coverage?: number, depth?: number,
 *   color?: number[], coordinates?: number[], derivatives?: Record<string, number[]>,
 *   texture_coordinates?: number[], level_of_detail?: number[]}} Fragment
 */

// Something that the device answers contradicts itself, or cannot be told: one sentence.
class Doubt extends Error {}

const PLAIN_BUFFERS = 2;
const DETAIL_BUFFERS = 5;
const LEVEL_BUFFERS = 6;
const MOST_OF_BYTES = 255;
// Of primitives that are counted one by one.
const MOST_COUNTED = 4096;

/** What a scene's fragments tell: a kind of program, and the number of images that it writes.
 * @param {Scene} scene @param {Limits} limits */
function formOf({details, draws}, limits) {
  if (!details || details.length === 0) return {kind: "capture", buffers: PLAIN_BUFFERS};
  return details.includes("texture") && draws.some((draw) => tellsLevels(draw, limits))
    ? {kind: "levels", buffers: LEVEL_BUFFERS} : {kind: "details", buffers: DETAIL_BUFFERS};
}

/** @param {Fragment} fragment @param {string[]} details @param {Draw} draw
 * @param {(buffer: number) => number[]} at */
function addDetails(fragment, details, at, draw) {
  if (details.includes("coordinates")) fragment.coordinates = at(2);
  if (details.includes("derivatives")) fragment.derivatives = {dFdx: at(3), dFdy: at(4)};
  if (details.includes("texture") && draw.texture) fragment.texture_coordinates = at(0).slice(2);
}

class Capture {
  /** @param {SceneRenderer} renderer */
  constructor(renderer) {
    this.renderer = renderer;
    this.gl = renderer.gl;
  }

  /**
   * Fragments that are made, or pass all tests, by pixel.
   * @param {Scene} scene @param {TargetSet} set @param {string} purpose ALL or HITS
   * @param {number} only one primitive, or all (-1)
   */
  counts(scene, set, purpose, only = -1) {
    const step = 1 / MOST_OF_BYTES;
    const counts = this.sums(scene, set.color, purpose, only, step);
    if (!counts.includes(MOST_OF_BYTES)) return counts;
    const {has} = this.renderer.limits;
    if (!has.EXT_color_buffer_float || !has.EXT_float_blend)
      throw new Doubt(`more than ${MOST_OF_BYTES - 1} hits of a pixel are not counted` +
        lacks("EXT_color_buffer_float or EXT_float_blend"));
    return this.sums(scene, set.other("counts", [this.gl.R32F]), purpose, only, 1);
  }

  /** @param {Scene} scene @param {Framebuffer} framebuffer */
  sums(scene, framebuffer, purpose, only, step) {
    framebuffer.bind();
    clearAll(this.gl, scene.target, [0, 0, 0, 0]);
    this.renderer.drawAll(scene, "count", purpose, true, (program) => {
      program.float("hit_step", step);
      program.integer("only", only);
    });
    const read = step < 1 ? framebuffer.bytes() : framebuffer.floats();
    return Array.from({length: read.length / 4}, (_, i) => read[4 * i]);
  }

  /** All fragments, and their number by pixel. @param {Scene} scene @param {TargetSet} set */
  fragments(scene, set) {
    const made = this.counts(scene, set, ALL);
    const {kind, buffers} = formOf(scene, this.renderer.limits);
    const formats = Array(buffers).fill(this.gl.RGBA32UI);
    const pair = ["even", "odd"].map((name) => set.other(`${name} ${buffers}`, formats));
    /** @type {Fragment[]} */
    const fragments = [];
    const open = made.slice();
    for (let layer = 0; open.some((count) => count > 0); ++layer) {
      const before = fragments.length;
      this.drawLayer(scene, pair[layer % 2], layer > 0 ? pair[(layer + 1) % 2] : null, kind);
      this.readLayer(scene, pair[layer % 2], open, fragments);
      if (fragments.length === before) break;
    }
    if (open.some((count) => count < 0)) throw this.contradiction(open, made, scene);
    if (open.some((count) => count > 0)) this.addRepeated(scene, set, open, made, fragments);
    return {fragments, made};
  }

  contradiction(open, made, scene) {
    const i = open.findIndex((count) => count !== 0);
    const {width} = scene.target;
    return new Doubt(`pixel (${i % width}, ${Math.floor(i / width)}) has ${made[i]} hits, and ${
      made[i] - open[i]} fragments`);
  }

  /** @param {Scene} scene @param {Framebuffer} into @param {Framebuffer} above or null */
  drawLayer(scene, into, above, kind) {
    const gl = this.gl;
    into.bind();
    resetState(gl);
    gl.clearBufferuiv(gl.COLOR, 0, [0, 0, 0, 0]);
    gl.activeTexture(gl.TEXTURE0 + ABOVE_UNIT);
    gl.bindTexture(gl.TEXTURE_2D, above && above.images[0]);
    this.renderer.drawAll(scene, kind, ALL, false, (program) => {
      program.integer("above", ABOVE_UNIT);
      program.integer("peels", above ? 1 : 0);
    });
    gl.activeTexture(gl.TEXTURE0 + ABOVE_UNIT);
    gl.bindTexture(gl.TEXTURE_2D, null);
  }

  /** @param {Scene} scene @param {Framebuffer} layer @param {Fragment[]} fragments */
  readLayer(scene, layer, open, fragments) {
    const words = layer.images.map((_, i) => layer.words(i));
    const floats = words.map((buffer) => new Float32Array(buffer.buffer));
    const {width, height} = scene.target;
    const draws = drawsByPrimitive(scene);
    for (let i = 0; i < width * height; ++i) {
      const number = words[0][4 * i];
      if (number === 0) continue;
      const [x, y] = [i % width, Math.floor(i / width)];
      if (number === 1)
        throw new Doubt(`the fragment at pixel (${x}, ${y}) has the flat attributes of a vertex ` +
          "that provokes no primitive");
      if (number - 2 >= draws.length)
        throw new Doubt(`the fragment at pixel (${x}, ${y}) has the number of no primitive`);
      --open[i];
      const at = (buffer) => [...floats[buffer].subarray(4 * i, 4 * i + 4)];
      /** @type {Fragment} */
      const fragment = {x, y, primitive: number - 2, depth: floats[0][4 * i + 1], color: at(1)};
      if (words.length > PLAIN_BUFFERS) addDetails(fragment, scene.details, at, draws[number - 2]);
      // The last buffer is that of the levels; the third word says whether there are any.
      if (words.length === LEVEL_BUFFERS && words[5][4 * i + 2])
        fragment.level_of_detail = [at(5)[0] - draws[number - 2].texture.base_level, at(5)[1]];
      fragments.push(fragment);
    }
  }

  // A fragment that a primitive repeats has been overwritten: where it is is known, and no more.
  /** @param {Scene} scene @param {TargetSet} set @param {Fragment[]} fragments */
  addRepeated(scene, set, open, made, fragments) {
    const primitives = drawsByPrimitive(scene).length;
    if (primitives > MOST_COUNTED) throw this.contradiction(open, made, scene);
    const {width} = scene.target;
    for (let primitive = 0; primitive < primitives; ++primitive)
      this.counts(scene, set, ALL, primitive).forEach((count, i) => {
        for (; count > 1; --count, --open[i])
          fragments.push({x: i % width, y: Math.floor(i / width), primitive});
      });
    if (open.some((count) => count !== 0)) throw this.contradiction(open, made, scene);
  }
}
