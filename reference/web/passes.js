// SPDX-License-Identifier: MIT
// Supersampled scenes: each pass a scene of its own, and the weighted mean of what all show.

const PRODUCT = `
uniform sampler2D image;
uniform float factor;
layout(location = 0) out vec4 target;
void main() { target = texelFetch(image, ivec2(gl_FragCoord.xy), 0) * factor; }
`;
const QUOTIENT = PRODUCT.replace("* factor", "/ factor");

// Colours and weights whose products and sums are float32 numbers that need all 24 digits, and lie
// outside [0, 1].
const PROVEN = {
  colors: [[-2.5, 2 ** -20, 2 ** 21, 1], [1, 1, 1, 0.75]], weights: [7, 1],
  sum: [-16.5, 7 * 2 ** -20 + 1, 7 * 2 ** 21 + 1, 7.75],
};

/** The scene of a pass: its vertices are moved, so that the centre of a pixel shows what was at the
 * pass's place. @param {Scene} scene @param {number[]} pass @returns {Scene} */
function passOf(scene, [x, y]) {
  const {supersampling, ...target} = scene.target;
  const move = (/** @type {Vertex} */ vertex) => ({...vertex,
    position: [vertex.position[0] + 0.5 - x, vertex.position[1] + 0.5 - y, vertex.position[2]]});
  return {...scene, target,
    draws: scene.draws.map((draw) => ({...draw, vertices: draw.vertices.map(move)}))};
}

class Accumulator {
  /** @param {SceneRenderer} renderer */
  constructor(renderer) {
    this.renderer = renderer;
    this.gl = renderer.gl;
    this.problem = undefined;  // with adding floats, once that was tried
  }

  /** @param {Framebuffer} from @param {Framebuffer} to */
  draw(source, factor, from, to) {
    const gl = this.gl;
    this.renderer.buffers.cover(to, source, (program) => {
      gl.activeTexture(gl.TEXTURE0 + ABOVE_UNIT);
      gl.bindTexture(gl.TEXTURE_2D, from.images[0]);
      program.integer("image", ABOVE_UNIT);
      program.float("factor", factor);
    });
    gl.bindTexture(gl.TEXTURE_2D, null);
  }

  /** @param {Framebuffer} pass @param {Framebuffer} sum */
  add(pass, weight, sum) {
    const gl = this.gl;
    resetState(gl);
    gl.enable(gl.BLEND);
    gl.blendEquation(gl.FUNC_ADD);
    gl.blendFunc(gl.ONE, gl.ONE);
    this.draw(PRODUCT, weight, pass, sum);
    gl.disable(gl.BLEND);
  }

  clear(framebuffer, color) {
    framebuffer.bind();
    resetState(this.gl);
    this.gl.clearBufferfv(this.gl.COLOR, 0, color);
  }

  prove() {
    const [pass, sum] = [0, 1].map(() => new Framebuffer(this.gl, [this.gl.RGBA32F], 1, 1));
    this.clear(sum, [0, 0, 0, 0]);
    PROVEN.colors.forEach((color, k) => {
      this.clear(pass, color);
      this.add(pass, PROVEN.weights[k], sum);
    });
    const added = [...sum.floats()];
    for (const framebuffer of [pass, sum]) framebuffer.free();
    return added.every((number, i) => number === PROVEN.sum[i]) ? ""
      : `this device does not add 32-bit floating-point colours by blending: what should be ${
        PROVEN.sum} is ${added}`;
  }

  /** @param {Scene} scene */
  render(scene) {
    if (this.problem === undefined) this.problem = this.prove();
    if (this.problem) throw new Doubt(this.problem);
    const {supersampling, ...target} = scene.target;
    const set = this.renderer.targets.find(target);
    const floats = [this.gl.RGBA32F];
    const [pass, sum] = [set.other("pass", floats), set.other("sum", floats)];
    this.clear(sum, [0, 0, 0, 0]);
    const passes = supersampling.map((place) => {
      const one = passOf(scene, place);
      const rendering = this.renderer.renderOne(one);
      pass.bind();
      clearAll(this.gl, target, target.clear);
      this.renderer.drawAll(one, "color", PIXELS, false);
      this.add(pass, place[2], sum);
      return rendering;
    });
    resetState(this.gl);
    this.draw(QUOTIENT, supersampling.reduce((total, place) => total + place[2], 0), sum, pass);
    const accumulated = [...pass.floats()];
    this.draw(PRODUCT, 1, pass, set.color);
    return {pixels: [...set.color.bytes()], accumulated, passes};
  }
}
