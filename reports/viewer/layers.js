// SPDX-License-Identifier: MIT The layers over the pixels, and from which size on they are drawn.

const CLOSE_UP = 2.7;           // pixels across the close-up
const RESOLVED_ALPHA = 0.3;     // of resolved pixels under their samples
const NEAR = 12;                // pixels across exact and rendered beside a scene's verdicts
const CROWD = 400;              // outlines and vertices, beyond which they would hide the picture
const CROWD_FROM = 16;          // CSS pixels per pixel from which even so many are drawn

// The user's choices, kept from case to case. Null: not chosen, so the case decides.
const Layers = {
  samples: true, grid: true, quads: false, clip: null, shapes: true, rule: true, markers: true,
};
const LAYER_NAMES = {
  samples: "Samples", grid: "Grid", quads: "Quads", clip: "Clip volume", shapes: "Primitives",
  rule: "Rule figure", markers: "Markers",
};

// By default the clip volume is drawn over cases about it.
const isDrawn = (id, one) => Layers[id] ?? one.rules.includes("clip.volume");

// The position of the clip volume as text, since its sides may be out of sight.
const clipWords = ([x, y, width, height]) =>
  "clip volume x " + x + " to " + (x + width) + ", y " + y + " to " + (y + height);
