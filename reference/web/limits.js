// SPDX-License-Identifier: MIT
// What WebGL 2, or the device below it, cannot draw as requested, as a sentence. An empty one: it can.

// The extensions that some scenes need; those that a device has are switched on at the start.
const EXTENSIONS = ["EXT_color_buffer_float", "EXT_float_blend", "OES_texture_float_linear",
  "EXT_texture_filter_anisotropic", "OES_sample_variables", "OES_shader_multisample_interpolation",
  "NV_shader_noperspective_interpolation", "EXT_polygon_offset_clamp", "WEBGL_provoking_vertex",
  "WEBGL_debug_renderer_info"];

/**
 * @typedef {{has: Record<string, any>, viewport: Int32Array, size: number, lineWidths: Float32Array,
 *   pointSizes: Float32Array, anisotropy: number, sampleCounts: number[], floatSamples: number[],
 *   drawBuffers: number, takesSaturatedDestinations: boolean, provokes: {first: boolean,
 *   last: boolean}}} Limits
 * @param {WebGL2RenderingContext} gl
 * @returns {Limits}
 */
function findLimits(gl) {
  const has = {};
  for (const name of EXTENSIONS) has[name] = gl.getExtension(name);
  const anisotropic = has.EXT_texture_filter_anisotropic;
  const samples = (format) =>
    [...(gl.getInternalformatParameter(gl.RENDERBUFFER, format, gl.SAMPLES) || [])].reverse();
  gl.blendFunc(gl.ONE, gl.SRC_ALPHA_SATURATE);
  const takesSaturatedDestinations = gl.getError() === gl.NO_ERROR;
  gl.blendFunc(gl.ONE, gl.ZERO);
  return {
    has, takesSaturatedDestinations,
    viewport: gl.getParameter(gl.MAX_VIEWPORT_DIMS),
    size: Math.min(gl.getParameter(gl.MAX_RENDERBUFFER_SIZE), gl.getParameter(gl.MAX_TEXTURE_SIZE)),
    lineWidths: gl.getParameter(gl.ALIASED_LINE_WIDTH_RANGE),
    pointSizes: gl.getParameter(gl.ALIASED_POINT_SIZE_RANGE),
    anisotropy: anisotropic ? gl.getParameter(anisotropic.MAX_TEXTURE_MAX_ANISOTROPY_EXT) : 1,
    sampleCounts: samples(gl.RGBA8),
    floatSamples: has.EXT_color_buffer_float ? samples(gl.RGBA32F) : [],
    drawBuffers: Math.min(gl.getParameter(gl.MAX_DRAW_BUFFERS),
      gl.getParameter(gl.MAX_COLOR_ATTACHMENTS)),
    provokes: {first: Boolean(has.WEBGL_provoking_vertex), last: true},
  };
}

const rangeText = (range) => `${range[0]} to ${range[1]}`;
const lacks = (name) => `: this device's WebGL lacks ${name}`;

/** @param {Scene} scene @param {Limits} limits */
function sampleLimit(scene, limits) {
  const {target} = scene;
  if (target.samples === 1) return "";
  if (!limits.sampleCounts.includes(target.samples))
    return `asked for ${target.samples} samples, this device makes ${limits.sampleCounts.join(", ")}`;
  if (target.sample_positions) return "WebGL 2 cannot place samples";
  if (scene.textures) return "textures are not drawn to multisampled targets";
  if (!limits.has.OES_sample_variables || !limits.has.OES_shader_multisample_interpolation)
    return "fragments do not tell their samples" +
      lacks("OES_sample_variables or OES_shader_multisample_interpolation");
  if (!limits.floatSamples.includes(target.samples))
    return `fragments do not tell their samples: this device has no 32-bit floating-point colours of
${target.samples} samples`.replace("\n", " ");
  return "";
}

/** @param {Scene} scene @param {Limits} limits */
function targetLimit(scene, limits) {
  const {target, viewport} = scene;
  if (target.surface === "window")
    return "a page has no window of its own: the browser draws a canvas into a framebuffer object";
  if (target.width > limits.size || target.height > limits.size)
    return `a ${target.width}x${target.height} target exceeds this device's ${limits.size}`;
  if (viewport[2] > limits.viewport[0] || viewport[3] > limits.viewport[1])
    return `a ${viewport[2]}x${viewport[3]} viewport exceeds this device's ` +
      `${limits.viewport[0]}x${limits.viewport[1]}`;
  if (target.stencil && target.depth === "depth16")
    return "OpenGL has no buffer of depth16 and stencil8";
  const range = scene.depth_range;
  if (range && range[0] > range[1]) return "WebGL has no depth range from far to near";
  if (target.supersampling) {
    if (!limits.has.EXT_color_buffer_float || !limits.has.EXT_float_blend)
      return "passes cannot be accumulated" + lacks("EXT_color_buffer_float or EXT_float_blend");
    if (scene.draws.some((draw) => draw.vertices.some((vertex) => vertex.clip)))
      return "passes of vertices in clip coordinates are not drawn in a page";
  }
  const {buffers} = formOf(scene, limits);
  if (buffers > limits.drawBuffers)
    return `details need ${buffers} draw buffers, this device has ${limits.drawBuffers}`;
  return sampleLimit(scene, limits);
}

/** @param {Scene} scene @param {Limits} limits */
function texturesLimit(scene, limits) {
  for (const texture of scene.textures || []) {
    if (texture.dimensions === 1) return "OpenGL ES has no one-dimensional textures";
    if (texture.format === "rgba32f" && texture.generated &&
        !(limits.has.OES_texture_float_linear && limits.has.EXT_color_buffer_float))
      return "levels of 32-bit floats are not generated" +
        lacks("OES_texture_float_linear or EXT_color_buffer_float");
  }
  return "";
}

/** @param {TextureUse} use @param {Scene} scene @param {Limits} limits */
function textureUseLimit(use, scene, limits) {
  if (use.lod_bias !== 0) return "OpenGL ES has no bias of a sampler's level of detail";
  if (use.wrap.includes("clamp-to-border")) return "WebGL 2 has no borders of textures";
  const filters = [use.magnify, use.minify, use.mipmap].includes("linear");
  if (scene.textures[use.texture].format === "rgba32f" && filters &&
      !limits.has.OES_texture_float_linear)
    return "32-bit floats are not filtered" + lacks("OES_texture_float_linear");
  if (use.max_anisotropy > limits.anisotropy)
    return `an anisotropy of ${use.max_anisotropy} exceeds this device's ${limits.anisotropy}`;
  return "";
}

// Whether only the near and the far plane can clip the vertex.
/** @param {Vertex} vertex */
function isBetweenSides(vertex, viewport) {
  if (vertex.clip)
    return Math.abs(vertex.clip[0]) <= vertex.clip[3] && Math.abs(vertex.clip[1]) <= vertex.clip[3];
  return [0, 1].every((axis) => vertex.position[axis] >= viewport[axis] &&
    vertex.position[axis] <= viewport[axis] + viewport[axis + 2]);
}

// Whether pixels of the target near a position may be beyond the viewport, along one axis.
function mayLeave(place, reach, origin, size, targetSize) {
  const end = origin + size;
  return (origin > 0 && place - reach < origin) || (end < targetSize && place + reach > end);
}

/** @param {Draw} draw @param {Scene} scene */
function sidesLimit(draw, scene) {
  const kind = KINDS[draw.primitive];
  if (kind === "triangle") return "";
  // Half of the thickness, plus the effect of rounding and of moving to whole pixels.
  const reach = (kind === "point" ? draw.point_size : draw.line_width) / 2 + 1;
  const {viewport, target} = scene;
  const sizes = [target.width, target.height];
  const isInside = (/** @type {Vertex} */ vertex) => isBetweenSides(vertex, viewport) &&
    [0, 1].every((axis) =>
      !mayLeave(vertex.position[axis], reach, viewport[axis], viewport[axis + 2], sizes[axis]));
  if (draw.vertices.every(isInside)) return "";
  return "points and lines beyond the viewport are not asked of WebGL: it lets browsers discard " +
    "such points, which OpenGL ES does not";
}

/** @param {Draw} draw @param {Target} target @param {Limits} limits */
function sizeLimit(draw, target, limits) {
  const kind = KINDS[draw.primitive];
  const size = draw.point_size;
  if (kind === "point" && (size < limits.pointSizes[0] || size > limits.pointSizes[1]))
    return `points of size ${size} are not drawn by this device: it has ${
      rangeText(limits.pointSizes)}`;
  if (kind !== "line") return "";
  const width = draw.line_width;
  // With several samples a width is not rounded; otherwise to a whole number, at least 1.
  const fits = target.samples > 1
    ? width >= limits.lineWidths[0] && width <= limits.lineWidths[1]
    : Math.floor(width + 0.5) <= Math.max(1, limits.lineWidths[1]);
  return fits ? "" : `lines of width ${width} are not drawn by this device: it has ${
    rangeText(limits.lineWidths)}`;
}

// WebGL raises errors for some states that OpenGL allows.
/** @param {Draw} draw @param {Limits} limits */
function operationsLimit(draw, limits) {
  const {stencil, blend, polygon_offset: offset} = draw;
  if (offset && offset.clamp !== 0 && !limits.has.EXT_polygon_offset_clamp)
    return "polygon offsets cannot be clamped" + lacks("EXT_polygon_offset_clamp");
  if (stencil && ["reference", "read_mask", "write_mask"].some(
    (key) => stencil.front[key] !== stencil.back[key]))
    return "WebGL has one stencil reference and one pair of masks for both faces";
  if (!blend) return "";
  const terms = [blend.color, blend.alpha];
  if (!limits.takesSaturatedDestinations &&
      terms.some((term) => term.destination === "src_alpha_saturate"))
    return "src_alpha_saturate is no destination's factor on this device";
  const {source, destination} = blend.color;
  const uses = (part) => [source, destination].some((factor) => factor.endsWith(part));
  if (uses("constant_color") && uses("constant_alpha"))
    return "WebGL has no blending by a constant's colour and its alpha at once";
  return "";
}

/** @param {Draw} draw @param {Scene} scene @param {Limits} limits */
function multisamplingLimit(draw, scene, limits) {
  if (scene.target.samples === 1) return "";
  const use = draw.multisampling;
  if (!use.enabled) return "OpenGL ES cannot switch multisampling off";
  if (use.location === "centroid" && !permitsAll(draw, scene.target.samples))
    return "WebGL 2 has the shader's sample mask alone, which comes after centroids are found";
  const least = leastInvocations(draw, scene.target.samples);
  return least === 1 || least === scene.target.samples ? ""
    : `WebGL 2 has shaders that run once or for each sample, not at least ${least} times`;
}

/** @param {Draw} draw @param {Scene} scene @param {Limits} limits */
function drawLimit(draw, scene, limits) {
  if (KINDS[draw.primitive] !== "point" && !limits.provokes[draw.provoking_vertex])
    return limits.has.WEBGL_provoking_vertex || draw.provoking_vertex === "last"
      ? `the ${draw.provoking_vertex} vertex does not provoke on this device, where it should`
      : "OpenGL ES has no first vertex convention: a primitive's last vertex provokes";
  if (draw.interpolation === "noperspective" && !limits.has.NV_shader_noperspective_interpolation)
    return "attributes are not interpolated without perspective" +
      lacks("NV_shader_noperspective_interpolation");
  return multisamplingLimit(draw, scene, limits) || sizeLimit(draw, scene.target, limits) ||
    operationsLimit(draw, limits) ||
    (draw.texture ? textureUseLimit(draw.texture, scene, limits) : "") || sidesLimit(draw, scene);
}

/** @param {Scene} scene @param {Limits} limits */
function limitExceededBy(scene, limits) {
  const problem = targetLimit(scene, limits) || texturesLimit(scene, limits);
  if (problem) return problem;
  for (const draw of scene.draws) {
    const limit = drawLimit(draw, scene, limits);
    if (limit) return limit;
  }
  return "";
}
