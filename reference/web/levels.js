// SPDX-License-Identifier: MIT
// The levels of detail of implicit lookups. WebGL has no textureQueryLod: they are read off the
// results of lookups in textures whose level k holds the number k.
//
// One has the levels of the scene's own texture and the draw's sampler, and shows the level that is
// accessed. The other one, a ruler, shows the level of detail before it is clamped. Its size is that
// of the base level times a power of two, which the coordinates are divided by: the level of detail
// stays what it is, to the bit. A ruler is as long as its levels are many. For what lies beyond its
// ends the coordinates are multiplied by further powers of two, which shift the level of detail: such
// numbers are rounded once by the addition, the others are not.

const ACCESSED_UNIT = 2;
const RULER_UNIT = 3;
const RULER_SIZE = 1024;  // at most, unless the texture is larger
// By the lengths of a ruler, the first that fits being taken.
const SHIFTS = [0, 1, -1, 2, -2];

const MEASURE = `
uniform highp sampler2D accessed;
uniform highp sampler2D ruler;
uniform vec4 windows[${SHIFTS.length}];
uniform float ruler_end;
uvec4 measured(vec2 at) {
  float level = 0.0;
  uint found = 0u;
  for (int i = 0; i < ${SHIFTS.length}; ++i) {
    float there = texture(ruler, at * windows[i].x).x;
    if (found == 0u && there > 0.0 && there < ruler_end) {
      level = there - windows[i].y;
      found = 1u;
    }
  }
  return uvec4(floatBitsToUint(texture(accessed, at).x), floatBitsToUint(level), found, 0u);
}
`;

/** Are the levels of detail of a draw's fragments told? @param {Draw} draw @param {Limits} limits */
function tellsLevels({texture: use}, limits) {
  return use !== undefined && use.lookup.kind === "implicit" && use.max_anisotropy === 1 &&
    Boolean(limits.has.OES_texture_float_linear);
}

/** The sizes of a chain of levels down to one texel. */
function chainOf(width, height) {
  const sizes = [[width, height]];
  for (; width > 1 || height > 1; sizes.push([width, height]))
    [width, height] = [width, height].map((size) => Math.max(1, size >> 1));
  return sizes;
}

class LevelTextures {
  /** @param {WebGL2RenderingContext} gl @param {Textures} textures whose sampler draws use */
  constructor(gl, textures) {
    this.gl = gl;
    this.textures = textures;
    /** @type {Map<string, WebGLTexture>} */
    this.kept = new Map();
    this.sampler = gl.createSampler();
    gl.samplerParameteri(this.sampler, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
    gl.samplerParameteri(this.sampler, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
  }

  /** Binds a texture to a unit; others have limits of levels of their own.
   * @param {number} unit @param {number[][]} sizes of its levels */
  bindLevels(unit, sizes) {
    const gl = this.gl;
    gl.activeTexture(gl.TEXTURE0 + unit);
    const key = [unit, ...sizes].join(" ");
    const found = this.kept.get(key) || gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, found);
    if (this.kept.has(key)) return;
    this.kept.set(key, found);
    sizes.forEach(([width, height], level) => gl.texImage2D(gl.TEXTURE_2D, level, gl.R32F, width,
      height, 0, gl.RED, gl.FLOAT, new Float32Array(width * height).fill(level)));
  }

  free() {
    for (const texture of this.kept.values()) this.gl.deleteTexture(texture);
    this.kept.clear();
  }

  /** @param {Program} program @param {Texture} texture @param {TextureUse} use */
  bind(program, texture, use) {
    const gl = this.gl;
    const [{width, height}] = texture.levels;
    const sizes = texture.generated ? chainOf(width, height)
      : texture.levels.map((level) => [level.width, level.height]);
    if (this.kept.size >= MOST_TEXTURES) this.free();
    this.bindLevels(ACCESSED_UNIT, sizes);
    this.textures.setLevels(use, sizes.length);
    gl.bindSampler(ACCESSED_UNIT, this.textures.sampler);
    program.integer("accessed", ACCESSED_UNIT);
    this.bindRuler(program, sizes[use.base_level]);
  }

  /** @param {Program} program @param {number[]} size of the base level */
  bindRuler(program, [width, height]) {
    const gl = this.gl;
    let scale = 1;
    while (Math.max(width, height) * scale * 2 <= RULER_SIZE) scale *= 2;
    const sizes = chainOf(width * scale, height * scale);
    const end = sizes.length - 1;
    this.bindLevels(RULER_UNIT, sizes);
    gl.bindSampler(RULER_UNIT, this.sampler);
    program.integer("ruler", RULER_UNIT);
    program.float("ruler_end", end);
    // Neighbours overlap by a level.
    program.vector("windows", SHIFTS.flatMap((steps) =>
      [2 ** (steps * (end - 1)) / scale, steps * (end - 1), 0, 0]));
  }

  unbind() {
    const gl = this.gl;
    for (const unit of [ACCESSED_UNIT, RULER_UNIT]) {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, null);
      gl.bindSampler(unit, null);
    }
  }
}
