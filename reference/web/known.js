// SPDX-License-Identifier: MIT
// What a page knows of a scene. All else, such as a key of a later version, may change what must be
// drawn, and is refused by name.

/**
 * What may be in a value: the keys of an object, or of each object of a list, with the same of their
 * values; a list of names; or null, for what needs no look.
 * @template T
 * @typedef {T extends string|number|boolean ? (string|number)[] | null
 *   : T extends (infer Item)[] ? Known<Item> : {[Key in keyof T]-?: Known<T[Key]>}} Known
 */

const COMPARISONS = ["never", "less", "equal", "lequal", "greater", "notequal", "gequal", "always"];

/** @type {Known<StencilFace>} */
const KNOWN_FACE = {
  test: COMPARISONS, reference: null, read_mask: null, write_mask: null,
  fail: Object.keys(STENCIL_OPERATIONS), depth_fail: Object.keys(STENCIL_OPERATIONS),
  pass: Object.keys(STENCIL_OPERATIONS),
};

const KNOWN_FACTORS = ["zero", "one", "src_alpha_saturate", ...["src", "dst", "constant"].flatMap(
  (whose) => ["color", "alpha"].flatMap((part) =>
    [`${whose}_${part}`, `one_minus_${whose}_${part}`]))];

/** @type {Known<BlendTerm>} */
const KNOWN_TERM = {
  equation: Object.keys(EQUATIONS), source: KNOWN_FACTORS, destination: KNOWN_FACTORS,
};

/** @type {Known<Scene>} */
const KNOWN_SCENE = {
  target: {
    width: null, height: null, samples: null, sample_positions: null, color: ["rgba8"],
    depth: ["depth16", "depth24", "depth32f"], stencil: ["stencil8"], surface: ["fbo", "window"],
    clear: null, clear_depth: null, clear_stencil: null, supersampling: null,
  },
  viewport: null,
  depth_range: null,
  details: ["coordinates", "derivatives", "texture"],
  textures: {
    dimensions: [1, 2], format: ["rgba8", "srgb8", "rgba32f"], generated: null,
    levels: {width: null, height: null, texels: null, texel: null},
  },
  draws: {
    primitive: Object.keys(MODES), interpolation: INTERPOLATIONS,
    provoking_vertex: ["first", "last"], line_width: null, point_size: null, scissor: null,
    multisampling: {
      enabled: null, location: ["center", "centroid", "sample"], min_sample_shading: null,
      mask: null, alpha_to_coverage: null,
    },
    texture: {
      texture: null, wrap: [...Object.keys(WRAPS), "clamp-to-border"],
      magnify: ["nearest", "linear"], minify: ["nearest", "linear"],
      mipmap: ["none", "nearest", "linear"], lod_bias: null, min_lod: null, max_lod: null,
      base_level: null, max_level: null, border: null, max_anisotropy: null,
      lookup: {kind: ["implicit", "bias", "lod", "gradients"], value: null, dx: null, dy: null},
    },
    front_face: ["ccw", "cw"], cull: ["none", ...Object.keys(CULLED)],
    polygon_offset: {factor: null, units: null, clamp: null},
    stencil: {front: KNOWN_FACE, back: KNOWN_FACE},
    depth: {test: COMPARISONS, write: null},
    blend: {color: KNOWN_TERM, alpha: KNOWN_TERM, constant: null},
    color_mask: null,
    vertices: {position: null, w: null, clip: null, color: null, texture_coordinates: null},
  },
};

/**
 * What is unknown in a value, after its place: `/draws/0 has the unknown key "warp"`. An empty
 * sentence: nothing.
 */
function unknownIn(value, known) {
  if (known === null) return "";
  const isList = Array.isArray(value);
  if (!isList && Array.isArray(known))
    return known.includes(value) ? "" : ` is the unknown name ${JSON.stringify(value)}`;
  for (const key in value) {
    if (!isList && !Object.hasOwn(known, key))
      return ` has the unknown key ${JSON.stringify(key)}`;
    const found = unknownIn(value[key], isList ? known : known[key]);
    if (found) return `/${key}${found}`;
  }
  return "";
}
