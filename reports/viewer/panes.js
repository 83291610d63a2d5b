// SPDX-License-Identifier: MIT Three canvases with a common view, and the images that lie under
// figures.

const MARGIN = {left: 26, right: 4, top: 4, bottom: 18};  // room for the axes, CSS pixels
const NO_MARGIN = {left: 0, right: 0, top: 0, bottom: 0};
const MAX_SCALE = 256;
const LEAST_HEIGHT = 400;  // CSS pixels of a case's pictures
const LEAST_SCENE = 512;   // and of a whole scene

const isNarrow = () => matchMedia("(max-width: 760px)").matches;

const ratioNow = () => window.devicePixelRatio || 1;

// The view of a canvas: the image place in its middle, and `scale`, canvas pixels per image pixel:
// whole numbers from 1 up, so that pixels stay crisp, and 1/2, 1/3, ... below.
class View {
  constructor(columns, rows) {
    this.columns = columns;
    this.rows = rows;
    this.how = "fit";  // "fit", "frame", "close": as the canvas allows; "": as chosen
    this.scale = 1;
    this.x = columns / 2;
    this.y = rows / 2;
  }

  // The largest scale at which the whole image shows in `width` x `height` canvas pixels.
  static fitting(columns, rows, width, height) {
    const room = Math.min(width / columns, height / rows);
    if (room >= 1) return Math.min(Math.floor(room), MAX_SCALE);
    return 1 / Math.ceil(1 / Math.max(room, 1e-3));
  }

  fit(width, height) {
    const rim = 6;  // for the outline of a chosen pixel at the border
    this.scale = View.fitting(this.columns, this.rows, width - rim, height - rim);
    this.x = this.columns / 2;
    this.y = this.rows / 2;
  }

  // The largest scale at which all of `box`, {left, bottom, right, top}, shows, but never so large
  // that the image leaves no room in the other direction: what differs fills the canvas.
  frame(box, width, height) {
    this.fit(width, height);
    const most = Math.max(width / this.columns, height / this.rows);
    const room = Math.min(width / (box.right - box.left), height / (box.top - box.bottom), most);
    if (this.scale < 1 || Math.floor(room) <= this.scale) return;
    this.scale = Math.min(Math.floor(room), MAX_SCALE);
    const along = (low, high, all, size) => {
      const half = size / this.scale / 2;
      return half * 2 >= all ? all / 2 : Math.min(Math.max((low + high) / 2, half), all - half);
    };
    this.x = along(box.left, box.right, this.columns, width);
    this.y = along(box.bottom, box.top, this.rows, height);
  }

  zoom(factor) {
    const next = this.scale * factor;
    this.how = "";
    if (next < 1) this.scale = 1 / Math.min(Math.round(1 / next), 64);
    else this.scale = Math.min(factor > 1 ? Math.ceil(next) : Math.floor(next), MAX_SCALE);
  }

  look(x, y) {
    this.how = "";
    this.x = x;
    this.y = y;
  }
}

function themeColors() {
  const style = getComputedStyle(document.documentElement);
  const color = (name) => style.getPropertyValue("--" + name).trim();
  const theme = {muted: color("muted"), plot: color("plot"), ink: color("ink")};
  for (const kind of Object.keys(KINDS)) theme["k-" + kind] = color("on-" + kind);
  for (const verdict of PIXEL_VERDICTS) theme["h-" + verdict] = color("heat-" + verdict);
  return theme;
}

// The mapping of one canvas for one frame.
function plotOf(canvas, view, margin = MARGIN) {
  const ratio = ratioNow();
  const left = Math.round(margin.left * ratio);
  const top = Math.round(margin.top * ratio);
  const width = canvas.width - left - Math.round(margin.right * ratio);
  const height = canvas.height - top - Math.round(margin.bottom * ratio);
  const originX = Math.round(left + width / 2 - view.x * view.scale);
  const originY = Math.round(top + height / 2 + view.y * view.scale);
  return {
    context: canvas.getContext("2d"), ratio, scale: view.scale, left, top, width, height,
    x: (x) => originX + x * view.scale,
    y: (y) => originY - y * view.scale,
    column: (x) => (x - originX) / view.scale,
    row: (y) => (originY - y) / view.scale,
  };
}

// Canvas of an image given bottom row first: the one place where the viewer turns y.
function imageOf(pixels, width, height) {
  const canvas = h("canvas", {width, height});
  const image = new ImageData(width, height);
  for (let row = 0; row < height; ++row)
    image.data.set(pixels.subarray(4 * width * row, 4 * width * (row + 1)),
      4 * width * (height - 1 - row));
  for (let i = 3; i < image.data.length; i += 4) image.data[i] = 255;
  canvas.getContext("2d").putImageData(image, 0, 0);
  return canvas;
}

const rgbOf = (color) => color.match(/[0-9a-f]{2}/gi).map((part) => parseInt(part, 16));

// A pale print of the exact image, with every pixel whose stored bytes differ tinted: strong where
// it is listed as a disagreement, weaker where the difference is within what is permitted.
function differenceImage(exact, rendered, width, height, kinds, theme) {
  const ground = rgbOf(theme.plot);
  const ink = rgbOf(theme.ink);
  const out = new Uint8ClampedArray(exact.length);
  for (let at = 0; at < exact.length; at += 4) {
    const light = (exact[at] + exact[at + 1] + exact[at + 2]) / 765;
    let differs = 0;
    for (let c = at; c < at + 4; ++c)
      differs = Math.max(differs, Math.abs(exact[c] - rendered[c]));
    const kind = kinds.get(at / 4) || (differs ? "value" : "");
    const tint = kind ? rgbOf(theme["k-" + kind]) : ground;
    const strength = kinds.has(at / 4) ? 0.62 : differs ? 0.18 + 0.3 * Math.sqrt(differs / 255) : 0;
    for (let c = 0; c < 3; ++c) {
      const base = ground[c] + (ink[c] - ground[c]) * 0.24 * light;
      out[at + c] = base + (tint[c] - base) * strength;
    }
  }
  return imageOf(out, width, height);
}

// The verdict of one difference: that of its pixel, if it is the worst there.
const verdictOf = (legality, cause) => Data.judged[legality][cause ? 1 : 0];

// The worst verdict at each pixel, by its place in the image; those that agree are absent. The
// report lists a limited number of disagreements and values of an answer.
function verdictsByPixel(answer, width, exact, rendered) {
  const found = new Map();
  const add = (at, verdict) => {
    if (!found.has(at) || VERDICTS[verdict].rank > VERDICTS[found.get(at)].rank)
      found.set(at, verdict);
  };
  for (const v of answer.values)
    for (let i = 0; i < v.places.length; i += 2)
      add(v.places[i + 1] * width + v.places[i], verdictOf("legal", v.cause));
  for (const d of answer.disagreements) add(d.y * width + d.x, verdictOf(d.legality, d.cause));
  for (let at = 0; rendered && at < exact.length; at += 4)
    for (let c = at; c < at + 4; ++c)
      if (exact[c] !== rendered[c] && !found.has(at / 4)) add(at / 4, verdictOf("legal"));
  return found;
}

// A pale print of the exact image with every pixel in the colour of its verdict.
function heatImage(exact, rendered, answer, width, height, theme) {
  const ground = rgbOf(theme.plot);
  const ink = rgbOf(theme.ink);
  const verdicts = verdictsByPixel(answer, width, exact, rendered);
  const out = new Uint8ClampedArray(exact.length);
  for (let at = 0; at < exact.length; at += 4) {
    const light = (exact[at] + exact[at + 1] + exact[at + 2]) / 765;
    const verdict = verdicts.get(at / 4);
    const tint = verdict && rgbOf(theme["h-" + verdict]);
    for (let c = 0; c < 3; ++c)
      out[at + c] = tint ? tint[c] : ground[c] + (ink[c] - ground[c]) * 0.2 * light;
  }
  return imageOf(out, width, height);
}
