// SPDX-License-Identifier: MIT
// A scene's textures and samplers, kept for the next scene with the same content.

const WRAPS = {repeat: "REPEAT", "mirrored-repeat": "MIRRORED_REPEAT", "clamp-to-edge": "CLAMP_TO_EDGE"};
const MOST_TEXTURES = 16;

/** All numbers of a level. @param {Level} level */
function texelsOf(level) {
  if (level.texels) return level.texels.map(toNumber);
  const count = level.width * level.height;
  const texel = level.texel.map(toNumber);
  return Array.from({length: 4 * count}, (_, i) => texel[i % 4]);
}

/** @param {WebGL2RenderingContext} gl @param {TextureUse} use */
function minifyingFilter(gl, use) {
  const filter = use.minify.toUpperCase();
  return gl[use.mipmap === "none" ? filter : `${filter}_MIPMAP_${use.mipmap.toUpperCase()}`];
}

class Textures {
  /** @param {WebGL2RenderingContext} gl @param {Limits} limits */
  constructor(gl, limits) {
    this.gl = gl;
    this.anisotropic = limits.has.EXT_texture_filter_anisotropic;
    /** @type {Map<string, {texture: WebGLTexture, levels: number}>} */
    this.kept = new Map();
    this.sampler = gl.createSampler();
  }

  /** @param {Texture} texture */
  find(texture) {
    const key = JSON.stringify(texture);
    let found = this.kept.get(key);
    if (found) return found;
    if (this.kept.size >= MOST_TEXTURES) {
      for (const old of this.kept.values()) this.gl.deleteTexture(old.texture);
      this.kept.clear();
    }
    found = this.make(texture);
    this.kept.set(key, found);
    return found;
  }

  /** @param {Texture} texture */
  make(texture) {
    const gl = this.gl;
    const made = gl.createTexture();
    gl.activeTexture(gl.TEXTURE0 + IMAGE_UNIT);
    gl.bindTexture(gl.TEXTURE_2D, made);
    const isFloat = texture.format === "rgba32f";
    const format = {rgba8: gl.RGBA8, srgb8: gl.SRGB8_ALPHA8, rgba32f: gl.RGBA32F}[texture.format];
    texture.levels.forEach((level, number) => {
      const texels = texelsOf(level);
      gl.texImage2D(gl.TEXTURE_2D, number, format, level.width, level.height, 0, gl.RGBA,
        isFloat ? gl.FLOAT : gl.UNSIGNED_BYTE,
        isFloat ? new Float32Array(texels) : new Uint8Array(texels));
    });
    if (texture.generated) gl.generateMipmap(gl.TEXTURE_2D);
    return {texture: made, levels: texture.levels.length};
  }

  /** @param {Texture} texture @param {TextureUse} use */
  bind(texture, use) {
    const gl = this.gl;
    const {texture: found, levels} = this.find(texture);
    gl.activeTexture(gl.TEXTURE0 + IMAGE_UNIT);
    gl.bindTexture(gl.TEXTURE_2D, found);
    this.setLevels(use, texture.generated ? Infinity : levels);
    this.setSampler(use);
    gl.bindSampler(IMAGE_UNIT, this.sampler);
  }

  /** Of the bound texture. @param {TextureUse} use */
  setLevels(use, levels) {
    const gl = this.gl;
    // A texture of one level is complete by itself; levels beyond the last of a chain do not exist.
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_BASE_LEVEL, use.base_level);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAX_LEVEL, levels > 1 ? use.max_level : 0);
  }

  /** @param {TextureUse} use */
  setSampler(use) {
    const gl = this.gl;
    const integer = (name, value) => gl.samplerParameteri(this.sampler, name, value);
    integer(gl.TEXTURE_WRAP_S, gl[WRAPS[use.wrap[0]]]);
    integer(gl.TEXTURE_WRAP_T, gl[WRAPS[use.wrap[1]]]);
    integer(gl.TEXTURE_MAG_FILTER, gl[use.magnify.toUpperCase()]);
    integer(gl.TEXTURE_MIN_FILTER, minifyingFilter(gl, use));
    gl.samplerParameterf(this.sampler, gl.TEXTURE_MIN_LOD, use.min_lod);
    gl.samplerParameterf(this.sampler, gl.TEXTURE_MAX_LOD, use.max_lod);
    if (this.anisotropic)
      gl.samplerParameterf(this.sampler, this.anisotropic.TEXTURE_MAX_ANISOTROPY_EXT,
        use.max_anisotropy);
  }

  unbind() {
    this.gl.activeTexture(this.gl.TEXTURE0 + IMAGE_UNIT);
    this.gl.bindTexture(this.gl.TEXTURE_2D, null);
    this.gl.bindSampler(IMAGE_UNIT, null);
  }

  /** The levels that the device made of those textures that ask it to. @param {Scene} scene */
  chains(scene) {
    /** @type {Record<string, Level[]>} */
    const chains = {};
    (scene.textures || []).forEach((texture, i) => {
      if (texture.generated) chains[i] = this.readChain(texture);
    });
    return chains;
  }

  /** @param {Texture} texture */
  readChain(texture) {
    const gl = this.gl;
    const {texture: name} = this.find(texture);
    const framebuffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    const chain = [];
    let {width, height} = texture.levels[0];
    for (let level = 0; ; ++level) {
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, name, level);
      const isFloat = texture.format === "rgba32f";
      const texels = new (isFloat ? Float32Array : Uint8Array)(4 * width * height);
      gl.readPixels(0, 0, width, height, gl.RGBA, isFloat ? gl.FLOAT : gl.UNSIGNED_BYTE, texels);
      chain.push({width, height, texels: [...texels]});
      if (width === 1 && height === 1) break;
      width = Math.max(1, width >> 1);
      height = Math.max(1, height >> 1);
    }
    gl.deleteFramebuffer(framebuffer);
    return chain;
  }
}
