// SPDX-License-Identifier: MIT
// A scene as it comes in a request (reference/PROTOCOL.md), and its vertices as inputs of the vertex
// shader.

/**
 * @typedef {{position: number[], w?: number, clip?: number[], color: number[],
 *   texture_coordinates?: number[]}} Vertex
 * @typedef {{test: string, reference: number, read_mask: number, write_mask: number, fail: string,
 *   depth_fail: string, pass: string}} StencilFace
 * @typedef {{equation: string, source: string, destination: string}} BlendTerm
 * @typedef {{kind: string, value?: number, dx?: number[], dy?: number[]}} Lookup
 * @typedef {{texture: number, wrap: string[], magnify: string, minify: string, mipmap: string,
 *   lod_bias: number, min_lod: number, max_lod: number, base_level: number, max_level: number,
 *   border: number[], max_anisotropy: number, lookup: Lookup}} TextureUse
 * @typedef {{primitive: string, interpolation: string, provoking_vertex: string, line_width: number,
 *   point_size: number, scissor?: number[], vertices: Vertex[], texture?: TextureUse,
 *   multisampling?: {enabled: boolean, location: string, min_sample_shading?: number, mask: number,
 *     alpha_to_coverage: boolean},
 *   front_face?: string, cull?: string,
 *   polygon_offset?: {factor: number, units: number, clamp: number},
 *   stencil?: {front: StencilFace, back: StencilFace}, depth?: {test: string, write: boolean},
 *   blend?: {color: BlendTerm, alpha: BlendTerm, constant: number[]}, color_mask?: boolean[]}} Draw
 * @typedef {{width: number, height: number, samples: number, color: string, surface: string,
 *   clear: number[], depth?: string, stencil?: string, clear_depth?: number, clear_stencil?: number,
 *   sample_positions?: number[][], supersampling?: number[][]}} Target
 * @typedef {{width: number, height: number, texels?: (number|string)[], texel?: (number|string)[]}} Level
 * @typedef {{dimensions: number, format: string, generated: boolean, levels: Level[]}} Texture
 * @typedef {{target: Target, viewport: number[], depth_range?: number[], details?: string[],
 *   textures?: Texture[], draws: Draw[]}} Scene
 */

const KINDS = {
  points: "point", lines: "line", line_strip: "line", line_loop: "line",
  triangles: "triangle", triangle_strip: "triangle", triangle_fan: "triangle",
};

/** @param {Draw} draw */
function primitiveCount(draw) {
  const n = draw.vertices.length;
  return {points: n, lines: n / 2, line_strip: n - 1, line_loop: n, triangles: n / 3,
    triangle_strip: n - 2, triangle_fan: n - 2}[draw.primitive];
}

/** The number, in its draw, of the vertex that provokes a primitive. @param {Draw} draw */
function provokingVertex(draw, primitive) {
  const first = draw.provoking_vertex === "first";
  const n = draw.vertices.length;
  switch (draw.primitive) {
    case "points": return primitive;
    case "lines": return 2 * primitive + (first ? 0 : 1);
    case "line_strip": return primitive + (first ? 0 : 1);
    case "line_loop": return (primitive + (first ? 0 : 1)) % n;
    case "triangles": return 3 * primitive + (first ? 0 : 2);
    case "triangle_strip": return primitive + (first ? 0 : 2);
    default: return primitive + (first ? 1 : 2);
  }
}

// Vertices of a primitive that share none with others.
const OWN_VERTICES = {points: 1, lines: 2, triangles: 3};

// The clip coordinate that the division by w and the viewport take to a window coordinate. It is a
// float32 number, so its product with the size has at most 39 bits: multiplying first avoids
// rounding.
function toClip(window, origin, size, w) {
  return (window - (origin + size / 2)) * w / (size / 2);
}

/** @param {Vertex} vertex */
function clipPosition(vertex, viewport) {
  if (vertex.clip) return vertex.clip;
  const w = vertex.w === undefined ? 1 : vertex.w;
  const [x, y, z] = vertex.position;
  return [toClip(x, viewport[0], viewport[2], w), toClip(y, viewport[1], viewport[3], w), z * w, w];
}

// Numbers that are not finite come as words.
function toNumber(value) {
  if (typeof value === "number") return value;
  return {nan: NaN, inf: Infinity, "-inf": -Infinity}[value];
}

const VERTEX_BYTES = 36;
const NO_PRIMITIVE = -1;

/**
 * All draws' vertices, one after the other: clip coordinates, colour (or s, t, 0 and 1 in a textured
 * draw) and the number of the primitive. A fragment takes that number from the vertex that provokes,
 * and a vertex provokes one primitive at most.
 * @param {Scene} scene
 */
function vertexData(scene) {
  const count = scene.draws.reduce((sum, draw) => sum + draw.vertices.length, 0);
  const bytes = new ArrayBuffer(count * VERTEX_BYTES);
  const floats = new Float32Array(bytes);
  const integers = new Int32Array(bytes);
  const stride = VERTEX_BYTES / 4;
  let vertexBefore = 0;
  let primitiveBefore = 0;
  for (const draw of scene.draws) {
    draw.vertices.forEach((vertex, i) => {
      const at = (vertexBefore + i) * stride;
      floats.set(clipPosition(vertex, scene.viewport), at);
      floats.set(draw.texture ? [...vertex.texture_coordinates, 0, 1] : vertex.color, at + 4);
      const own = OWN_VERTICES[draw.primitive];
      integers[at + 8] = own ? primitiveBefore + Math.floor(i / own) : NO_PRIMITIVE;
    });
    const primitives = primitiveCount(draw);
    if (!OWN_VERTICES[draw.primitive])
      for (let i = 0; i < primitives; ++i)
        integers[(vertexBefore + provokingVertex(draw, i)) * stride + 8] = primitiveBefore + i;
    vertexBefore += draw.vertices.length;
    primitiveBefore += primitives;
  }
  return {bytes, primitives: primitiveBefore};
}

// Do some fragments undergo operations that can drop or change what they write?
/** @param {Scene} scene */
function hasFragmentOperations(scene) {
  return scene.draws.some((draw) => draw.stencil || draw.depth || draw.blend || draw.color_mask) ||
    scene.target.stencil !== undefined || scene.target.clear_depth !== undefined;
}

/** The draws of primitives with the textures that they look up. @param {Scene} scene */
function drawsByPrimitive(scene) {
  return scene.draws.flatMap((draw) => Array(primitiveCount(draw)).fill(draw));
}
