// SPDX-License-Identifier: MIT
// The device as a renderer: a request of reference/PROTOCOL.md to an answer.

/**
 * @typedef {{edgecase: number, id: string, digest: string, scene: Scene}} SceneRequest
 * @typedef {{pixels: number[], fragments?: Fragment[], hits?: number[], depths?: number[],
 *   stencils?: number[], sample_positions?: number[][], mip_chains?: Record<string, Level[]>,
 *   accumulated?: number[], passes?: Rendering[]}} Rendering
 * @typedef {Partial<Rendering> & {not_run?: string}} Answer a rendering, or why there is none
 */

const PROTOCOL_VERSION = 1;
const INTERPOLATIONS = ["flat", "smooth", "noperspective"];

class SceneRenderer {
  /** @param {WebGL2RenderingContext} gl */
  constructor(gl) {
    this.gl = gl;
    this.limits = findLimits(gl);
    this.programs = new Programs(gl, this.limits);
    this.targets = new Targets(gl);
    this.textures = new Textures(gl, this.limits);
    this.levels = new LevelTextures(gl, this.textures);
    this.buffers = new BufferReader(gl, this.programs);
    this.capture = new Capture(this);
    this.samples = new SampleCapture(this);
    this.accumulator = new Accumulator(this);
    gl.pixelStorei(gl.PACK_ALIGNMENT, 1);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    this.vertices = gl.createBuffer();
    this.vertexArray = this.makeVertexArray();
    this.probeProvokingVertices();
  }

  makeVertexArray() {
    const gl = this.gl;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.vertices);
    gl.vertexAttribPointer(0, 4, gl.FLOAT, false, VERTEX_BYTES, 0);
    gl.vertexAttribPointer(1, 4, gl.FLOAT, false, VERTEX_BYTES, 16);
    gl.vertexAttribIPointer(2, 1, gl.INT, VERTEX_BYTES, 32);
    for (const attribute of [0, 1, 2]) gl.enableVertexAttribArray(attribute);
    gl.bindVertexArray(null);
    return array;
  }

  // A call that is present need not have an effect.
  probeProvokingVertices() {
    for (const which of ["first", "last"])
      for (const primitive of ["lines", "triangles"]) {
        const scene = provokingScene(primitive, which);
        const outcome = this.outcomeOf(scene);
        // Primitives that cannot be drawn at all are refused with every scene.
        if (outcome.fragments && !obeysProvoking(outcome.fragments, scene))
          this.limits.provokes[which] = false;
      }
  }

  /** @param {Scene} scene @returns {Answer} */
  outcomeOf(scene) {
    const limit = limitExceededBy(scene, this.limits);
    if (limit) return {not_run: limit};
    try {
      const rendering = this.render(scene);
      const error = takeError(this.gl);
      return error ? {not_run: `drawing raised ${error}`} : rendering;
    } catch (fault) {
      takeError(this.gl);
      if (fault instanceof Doubt || fault instanceof ProgramError)
        return {not_run: fault.message};
      throw fault;
    }
  }

  /** @param {Scene} scene @returns {Rendering} */
  render(scene) {
    if (scene.target.supersampling) return this.accumulator.render(scene);
    if (scene.target.samples > 1) {
      this.upload(scene);
      return this.samples.render(scene);
    }
    return this.renderOne(scene);
  }

  /** @param {Scene} scene @returns {Rendering} */
  renderOne(scene) {
    const {target} = scene;
    const doubt = this.buffers.doubtOf(target);
    if (doubt) throw new Doubt(doubt);
    const found = this.targets.find(target);
    if (!found.color.complete)
      throw new Doubt(`this device has no ${target.width}x${target.height} framebuffer` +
        (target.depth || target.stencil ? " with the asked depth or stencil buffer" : ""));
    this.upload(scene);
    found.color.bind();
    clearAll(this.gl, target, target.clear);
    this.drawAll(scene, "color", PIXELS, false);
    /** @type {Rendering} */
    const rendering = {pixels: [...found.color.bytes()]};
    if (target.depth) rendering.depths = this.buffers.depths(found);
    if (target.stencil) rendering.stencils = this.buffers.stencils(found);
    const {fragments, made} = this.capture.fragments(scene, found);
    rendering.fragments = fragments;
    rendering.hits = hasFragmentOperations(scene) ? this.capture.counts(scene, found, HITS) : made;
    const chains = this.textures.chains(scene);
    if (Object.keys(chains).length > 0) rendering.mip_chains = chains;
    return rendering;
  }

  /** @param {Scene} scene */
  upload(scene) {
    this.gl.bindBuffer(this.gl.ARRAY_BUFFER, this.vertices);
    this.gl.bufferData(this.gl.ARRAY_BUFFER, vertexData(scene).bytes, this.gl.STREAM_DRAW);
  }

  /**
   * Draws a scene into the bound framebuffer.
   * @param {Scene} scene
   * @param {string} kind of program
   * @param {string} purpose of the pass
   * @param {boolean} adds are colours added up?
   * @param {(program: Program) => void} prepare sets further uniforms
   */
  drawAll(scene, kind, purpose, adds, prepare = () => {}) {
    const gl = this.gl;
    let first = 0;
    for (const draw of scene.draws) {
      gl.bindVertexArray(this.vertexArray);
      setState(gl, this.limits, scene, draw, purpose, adds);
      if (draw.texture) this.textures.bind(scene.textures[draw.texture.texture], draw.texture);
      const program = this.programs.forDraw(kind, draw, scene.target.samples);
      program.integer("interpolation", INTERPOLATIONS.indexOf(draw.interpolation));
      program.float("point_size", draw.point_size);
      program.integer("image", IMAGE_UNIT);
      if (draw.multisampling) program.integer("sample_mask", draw.multisampling.mask);
      if (draw.texture) this.setLookup(program, draw.texture.lookup);
      if (kind === "levels" && tellsLevels(draw, this.limits))
        this.levels.bind(program, scene.textures[draw.texture.texture], draw.texture);
      prepare(program);
      gl.drawArrays(gl[MODES[draw.primitive]], first, draw.vertices.length);
      first += draw.vertices.length;
    }
    this.textures.unbind();
    if (kind === "levels") this.levels.unbind();
    gl.bindVertexArray(null);
    resetState(gl);
  }

  /** @param {Program} program @param {Lookup} lookup */
  setLookup(program, lookup) {
    if (lookup.value !== undefined) program.float("lookup_value", lookup.value);
    if (lookup.dx) program.vector("gradients", [...lookup.dx, ...lookup.dy]);
  }
}

/** A line or triangle whose vertices differ in colour. @returns {Scene} */
function provokingScene(primitive, which) {
  const corners = [[0, 0], [3, 1], [1, 3]].slice(0, primitive === "lines" ? 2 : 3);
  const vertices = corners.map(([x, y], i) => ({position: [x + 0.5, y + 0.5, 0],
    color: [0, 1, 2, 3].map((channel) => (channel === i || channel === 3 ? 1 : 0))}));
  return {
    target: {width: 4, height: 4, samples: 1, color: "rgba8", surface: "fbo", clear: [0, 0, 0, 1]},
    viewport: [0, 0, 4, 4],
    draws: [{primitive, interpolation: "flat", provoking_vertex: which, line_width: 1,
      point_size: 1, vertices}],
  };
}

/** @param {Fragment[]} fragments @param {Scene} scene */
function obeysProvoking(fragments, scene) {
  const [{vertices, provoking_vertex: which}] = scene.draws;
  const {color} = vertices[which === "first" ? 0 : vertices.length - 1];
  return fragments.length > 0 &&
    fragments.every((fragment) => fragment.color.every((value, i) => value === color[i]));
}
