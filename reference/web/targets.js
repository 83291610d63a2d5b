// SPDX-License-Identifier: MIT
// Framebuffers by size and formats, and what their depth and stencil buffers hold.
//
// A depth buffer is a texture that a shader fetches, which turns its integer n into a float32
// number: n / (2^bits - 1) rounded, or n times the rounded reciprocal. Which of both a device does,
// and that its buffer holds integers at all, is found by a ramp of depths.

const DEPTH_BITS = {depth16: 16, depth24: 24, depth32f: 0};
const IMAGE_UNIT = 0;
const ABOVE_UNIT = 1;
const MOST_SIZES = 12;

/** @param {WebGL2RenderingContext} gl */
function depthStencilStorage(gl, target) {
  const formats = {
    "depth16": [gl.DEPTH_COMPONENT16, gl.DEPTH_ATTACHMENT],
    "depth24": [gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT],
    "depth32f": [gl.DEPTH_COMPONENT32F, gl.DEPTH_ATTACHMENT],
    "depth24 stencil8": [gl.DEPTH24_STENCIL8, gl.DEPTH_STENCIL_ATTACHMENT],
    "depth32f stencil8": [gl.DEPTH32F_STENCIL8, gl.DEPTH_STENCIL_ATTACHMENT],
    "stencil8": [gl.STENCIL_INDEX8, gl.STENCIL_ATTACHMENT],
  };
  return formats[[target.depth, target.stencil].filter(Boolean).join(" ")];
}

/** An image that a shader can fetch, unfiltered. @param {WebGL2RenderingContext} gl */
function makeTexture(gl, format, width, height) {
  const texture = gl.createTexture();
  gl.activeTexture(gl.TEXTURE0 + ABOVE_UNIT);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  gl.bindTexture(gl.TEXTURE_2D, null);
  return texture;
}

class Framebuffer {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {number[]} formats of the colour images, one for each draw buffer
   * @param {Depth} depth or null
   */
  constructor(gl, formats, width, height, depth = null) {
    this.gl = gl;
    this.width = width;
    this.height = height;
    this.images = formats.map((format) => makeTexture(gl, format, width, height));
    this.name = gl.createFramebuffer();
    this.bind();
    const buffers = this.images.map((image, i) => {
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, image, 0);
      return gl.COLOR_ATTACHMENT0 + i;
    });
    gl.drawBuffers(buffers);
    if (depth) depth.attach();
    this.complete = gl.checkFramebufferStatus(gl.FRAMEBUFFER) === gl.FRAMEBUFFER_COMPLETE;
  }

  bind() {
    this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, this.name);
  }

  /** Four numbers a pixel, row by row from the bottom. */
  read(buffer, type, numbers) {
    const gl = this.gl;
    this.bind();
    gl.readBuffer(gl.COLOR_ATTACHMENT0 + buffer);
    gl.readPixels(0, 0, this.width, this.height,
      type === gl.UNSIGNED_INT ? gl.RGBA_INTEGER : gl.RGBA, type, numbers);
    return numbers;
  }

  bytes() {
    return this.read(0, this.gl.UNSIGNED_BYTE, new Uint8Array(4 * this.width * this.height));
  }

  floats(buffer = 0) {
    return this.read(buffer, this.gl.FLOAT, new Float32Array(4 * this.width * this.height));
  }

  words(buffer) {
    return this.read(buffer, this.gl.UNSIGNED_INT, new Uint32Array(4 * this.width * this.height));
  }

  free() {
    for (const image of this.images) this.gl.deleteTexture(image);
    this.gl.deleteFramebuffer(this.name);
  }
}

/** A depth or stencil buffer, or both in one. */
class Depth {
  /** @param {WebGL2RenderingContext} gl @param {Target} target */
  constructor(gl, target) {
    this.gl = gl;
    const [format, attachment] = depthStencilStorage(gl, target);
    this.format = format;
    this.attachment = attachment;
    const {samples, width, height} = target;
    // A stencil buffer alone cannot be a texture, and neither can one of several samples.
    this.texture = target.depth && samples === 1 ? makeTexture(gl, format, width, height) : null;
    if (this.texture) return;
    this.buffer = gl.createRenderbuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, this.buffer);
    if (samples === 1) gl.renderbufferStorage(gl.RENDERBUFFER, format, width, height);
    else gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, width, height);
  }

  /** To the bound framebuffer. */
  attach() {
    const gl = this.gl;
    if (this.texture)
      gl.framebufferTexture2D(gl.FRAMEBUFFER, this.attachment, gl.TEXTURE_2D, this.texture, 0);
    else gl.framebufferRenderbuffer(gl.FRAMEBUFFER, this.attachment, gl.RENDERBUFFER, this.buffer);
  }

  free() {
    this.gl.deleteTexture(this.texture);
    if (this.buffer) this.gl.deleteRenderbuffer(this.buffer);
  }
}

/** Clears the bound framebuffer's colour, and its depth and stencil as the target asks.
 * @param {WebGL2RenderingContext} gl @param {Target} target */
function clearAll(gl, target, color) {
  resetState(gl);
  gl.clearBufferfv(gl.COLOR, 0, color);
  if (target.depth)
    gl.clearBufferfv(gl.DEPTH, 0, [target.clear_depth === undefined ? 1 : target.clear_depth]);
  if (target.stencil) gl.clearBufferiv(gl.STENCIL, 0, [target.clear_stencil || 0]);
}

/** The framebuffers of one kind of target. */
class TargetSet {
  /** @param {WebGL2RenderingContext} gl @param {Target} target */
  constructor(gl, target) {
    this.gl = gl;
    this.target = target;
    this.depth = target.depth || target.stencil ? new Depth(gl, target) : null;
    this.color = this.framebuffer([gl.RGBA8]);
    this.others = new Map();
  }

  framebuffer(formats) {
    return new Framebuffer(this.gl, formats, this.target.width, this.target.height, this.depth);
  }

  /** A further framebuffer with the same depth buffer, made when first asked for. */
  other(name, formats) {
    if (!this.others.has(name)) this.others.set(name, this.framebuffer(formats));
    return this.others.get(name);
  }

  free() {
    for (const framebuffer of [this.color, ...this.others.values()]) framebuffer.free();
    if (this.depth) this.depth.free();
  }
}

class Targets {
  /** @param {WebGL2RenderingContext} gl */
  constructor(gl) {
    this.gl = gl;
    /** @type {Map<string, TargetSet>} */
    this.sets = new Map();
  }

  /** @param {Target} target */
  find(target) {
    const key = [target.width, target.height, target.depth, target.stencil].join(" ");
    let found = this.sets.get(key);
    if (found) return found;
    if (this.sets.size >= MOST_SIZES) {
      for (const set of this.sets.values()) set.free();
      this.sets.clear();
    }
    found = new TargetSet(this.gl, target);
    this.sets.set(key, found);
    return found;
  }
}
