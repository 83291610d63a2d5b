// SPDX-License-Identifier: MIT
// A draw's state. All of it is set for every draw, in one place.

const FACTORS = {zero: "ZERO", one: "ONE"};
const STENCIL_OPERATIONS = {keep: "KEEP", zero: "ZERO", replace: "REPLACE", incr: "INCR",
  incr_wrap: "INCR_WRAP", decr: "DECR", decr_wrap: "DECR_WRAP", invert: "INVERT"};
const EQUATIONS = {add: "FUNC_ADD", subtract: "FUNC_SUBTRACT",
  reverse_subtract: "FUNC_REVERSE_SUBTRACT", min: "MIN", max: "MAX"};
const CULLED = {front: "FRONT", back: "BACK", front_and_back: "FRONT_AND_BACK"};
const MODES = {points: "POINTS", lines: "LINES", line_strip: "LINE_STRIP", line_loop: "LINE_LOOP",
  triangles: "TRIANGLES", triangle_strip: "TRIANGLE_STRIP", triangle_fan: "TRIANGLE_FAN"};

// What a pass is for: its colours and buffers, the fragments that pass all tests, or all fragments.
const PIXELS = "pixels";
const HITS = "hits";
const ALL = "all";

const functionOf = (gl, test) => gl[test.toUpperCase()];
const factorOf = (gl, name) => gl[FACTORS[name] || name.toUpperCase()];

function enable(gl, capability, on) {
  if (on) gl.enable(capability);
  else gl.disable(capability);
}

/** @param {WebGL2RenderingContext} gl @param {Draw} draw */
function setStencil(gl, draw, tests) {
  enable(gl, gl.STENCIL_TEST, tests && draw.stencil !== undefined);
  if (!tests || !draw.stencil) return;
  for (const [face, which] of /** @type {[StencilFace, number][]} */ (
    [[draw.stencil.front, gl.FRONT], [draw.stencil.back, gl.BACK]])) {
    gl.stencilFuncSeparate(which, functionOf(gl, face.test), face.reference, face.read_mask);
    gl.stencilOpSeparate(which, gl[STENCIL_OPERATIONS[face.fail]],
      gl[STENCIL_OPERATIONS[face.depth_fail]], gl[STENCIL_OPERATIONS[face.pass]]);
    gl.stencilMaskSeparate(which, face.write_mask);
  }
}

// Without a buffer the test stays off. A pass for all fragments lets every one of them through.
/** @param {WebGL2RenderingContext} gl @param {Draw} draw */
function setDepthTest(gl, draw, hasDepth, tests) {
  const depth = tests ? draw.depth || {test: "always", write: true} : {test: "always", write: false};
  enable(gl, gl.DEPTH_TEST, hasDepth);
  gl.depthFunc(functionOf(gl, depth.test));
  gl.depthMask(depth.write);
}

/** @param {WebGL2RenderingContext} gl @param {Draw} draw */
function setBlending(gl, draw) {
  enable(gl, gl.BLEND, draw.blend !== undefined);
  const mask = draw.color_mask || [true, true, true, true];
  gl.colorMask(mask[0], mask[1], mask[2], mask[3]);
  if (!draw.blend) return;
  const {color, alpha, constant} = draw.blend;
  gl.blendEquationSeparate(gl[EQUATIONS[color.equation]], gl[EQUATIONS[alpha.equation]]);
  gl.blendFuncSeparate(factorOf(gl, color.source), factorOf(gl, color.destination),
    factorOf(gl, alpha.source), factorOf(gl, alpha.destination));
  gl.blendColor(constant[0], constant[1], constant[2], constant[3]);
}

/** @param {WebGL2RenderingContext} gl @param {Draw} draw @param {Limits} limits */
function setPolygons(gl, draw, limits) {
  gl.frontFace(draw.front_face === "cw" ? gl.CW : gl.CCW);
  enable(gl, gl.CULL_FACE, Boolean(CULLED[draw.cull]));
  if (CULLED[draw.cull]) gl.cullFace(gl[CULLED[draw.cull]]);
  const offset = draw.polygon_offset;
  enable(gl, gl.POLYGON_OFFSET_FILL, offset !== undefined);
  if (!offset) return;
  // The clamp persists until the next call of either function.
  if (offset.clamp === 0) gl.polygonOffset(offset.factor, offset.units);
  else
    limits.has.EXT_polygon_offset_clamp.polygonOffsetClampEXT(offset.factor, offset.units,
      offset.clamp);
}

/**
 * @param {WebGL2RenderingContext} gl @param {Limits} limits
 * @param {Scene} scene @param {Draw} draw
 * @param {string} purpose PIXELS, HITS or ALL
 * @param {boolean} adds are colours added up, or written?
 */
function setState(gl, limits, scene, draw, purpose, adds) {
  const {target, viewport} = scene;
  for (const off of [gl.DITHER, gl.SAMPLE_COVERAGE, gl.SAMPLE_ALPHA_TO_COVERAGE]) gl.disable(off);
  gl.viewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  enable(gl, gl.SCISSOR_TEST, draw.scissor !== undefined);
  if (draw.scissor) gl.scissor(draw.scissor[0], draw.scissor[1], draw.scissor[2], draw.scissor[3]);
  gl.lineWidth(draw.line_width);
  const range = scene.depth_range || [0, 1];
  gl.depthRange(range[0], range[1]);
  setPolygons(gl, draw, limits);
  setStencil(gl, draw, purpose !== ALL);
  setDepthTest(gl, draw, target.depth !== undefined, purpose !== ALL);
  enable(gl, gl.SAMPLE_ALPHA_TO_COVERAGE, purpose !== ALL &&
    draw.multisampling !== undefined && draw.multisampling.alpha_to_coverage);
  if (purpose === PIXELS) {
    setBlending(gl, draw);
  } else {
    gl.colorMask(true, true, true, true);
    enable(gl, gl.BLEND, adds);
    gl.blendEquation(gl.FUNC_ADD);
    gl.blendFunc(gl.ONE, gl.ONE);
  }
  const provoking = limits.has.WEBGL_provoking_vertex;
  if (provoking)
    provoking.provokingVertexWEBGL(draw.provoking_vertex === "first"
      ? provoking.FIRST_VERTEX_CONVENTION_WEBGL : provoking.LAST_VERTEX_CONVENTION_WEBGL);
}

// What must not outlive a pass: masks hold for clears, too.
/** @param {WebGL2RenderingContext} gl */
function resetState(gl) {
  for (const off of [gl.CULL_FACE, gl.POLYGON_OFFSET_FILL, gl.STENCIL_TEST, gl.DEPTH_TEST, gl.BLEND,
    gl.SCISSOR_TEST, gl.SAMPLE_ALPHA_TO_COVERAGE, gl.DITHER]) gl.disable(off);
  gl.frontFace(gl.CCW);
  gl.depthRange(0, 1);
  gl.depthMask(true);
  gl.stencilMask(0xff);
  gl.colorMask(true, true, true, true);
}

const ERRORS = ["INVALID_ENUM", "INVALID_VALUE", "INVALID_OPERATION",
  "INVALID_FRAMEBUFFER_OPERATION", "OUT_OF_MEMORY", "CONTEXT_LOST_WEBGL"];

/** The first error since it was last asked, or nothing. @param {WebGL2RenderingContext} gl */
function takeError(gl) {
  let first = "";
  for (let error = gl.getError(); error !== gl.NO_ERROR; error = gl.getError()) {
    first = first || ERRORS.find((name) => gl[name] === error) || String(error);
    if (error === gl.CONTEXT_LOST_WEBGL) break;
  }
  return first && "GL_" + first;
}
