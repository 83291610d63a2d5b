// SPDX-License-Identifier: MIT Numbers as machines hold them: the bits of a float32, the number of
// float32 steps between two numbers, and colours of eight bits.

const FloatView = new DataView(new ArrayBuffer(4));

// The bits of the float32 nearest to a number, as an unsigned integer.
function floatBits(value) {
  FloatView.setFloat32(0, Number(value));
  return FloatView.getUint32(0);
}

const isFloat32 = (value) => Object.is(Math.fround(Number(value)), Number(value));

// Steps from a to b; null where one is not a number.
function floatSteps(a, b) {
  if (Number.isNaN(Number(a)) || Number.isNaN(Number(b))) return null;
  const order = (bits) => (bits < 0x80000000 ? bits : 0x80000000 - bits);
  return order(floatBits(b)) - order(floatBits(a));
}

const hex = (number, digits) => number.toString(16).toUpperCase().padStart(digits, "0");
const bytesHex = (color) => "#" + color.map((byte) => hex(byte, 2)).join("");

// "0 01111110 00000000000000000000001": sign, exponent, fraction.
function bitGroups(bits) {
  const text = bits.toString(2).padStart(32, "0");
  return text.slice(0, 1) + " " + text.slice(1, 9) + " " + text.slice(9);
}

function numberCells(value) {
  const bits = floatBits(value);
  return [h("td", {}, short(value), !isFloat32(value) && h("span.faint", {
    title: "Not a float32: the bits are those of the nearest one"}, " \u2248")),
  h("td", {}, "0x" + hex(bits, 8)), h("td.bits", {}, bitGroups(bits))];
}

const LINE = {width: 264, left: 8, height: 46};  // CSS pixels of a number line

// Exact, what is permitted and what was rendered of one number, on a line that is as long as their
// distance: digits that all share say nothing. `permitted`: [low, high], or undefined.
function numberLine(name, exact, rendered, permitted) {
  const ends = [exact, rendered, ...(permitted || [])].map(Number).filter(Number.isFinite);
  const [low, high] = [Math.min(...ends), Math.max(...ends)];
  const span = high - low || Math.abs(high) || 1;
  const place = (v) => {
    const at = Number(v);
    const share = Number.isNaN(at) ? 1.06 : (Math.min(Math.max(at, low - span), high + span) - low) / span;
    return LINE.left + 10 + (LINE.width - 2 * LINE.left - 20) * Math.min(Math.max(share, -0.06), 1.06);
  };
  const steps = floatSteps(exact, rendered);
  const words = name + "exact " + short(exact) + (permitted ? ", permitted " + short(permitted[0]) +
    " to " + short(permitted[1]) : "") + ", rendered " + short(rendered) +
    (steps === null ? "" : ", " + (steps > 0 ? "+" : "") + steps.toLocaleString("en") + " ULP");
  const right = place(rendered) >= place(exact);
  const label = (text, x, y, anchor) => svgNode("text", {x, y, "text-anchor": anchor}, text);
  return h("div.number-line", {}, svgNode("svg", {role: "img", "aria-label": words, width: LINE.width,
    height: LINE.height, viewBox: "0 0 " + LINE.width + " " + LINE.height},
  svgNode("path", {class: "axis", d: "M" + LINE.left + " 23H" + (LINE.width - LINE.left)}),
  permitted && svgNode("rect", {class: "band", x: place(permitted[0]), y: 16, height: 14,
    width: Math.max(2, place(permitted[1]) - place(permitted[0]))}),
  svgNode("path", {class: "exact", d: "M" + place(exact) + " 14V32"}),
  svgNode("circle", {class: "rendered", cx: place(rendered), cy: 23, r: 4.5}),
  label(name + "exact " + short(exact), right ? LINE.left : LINE.width - LINE.left, 10, right ? "start" : "end"),
  label("rendered " + short(rendered), right ? LINE.width - LINE.left : LINE.left, 44, right ? "end" : "start")),
  steps !== null && h("small.faint", {}, (steps > 0 ? "+" : "") + steps.toLocaleString("en") + " ULP"));
}

// Those numbers of a disagreement that differ, each once.
function numberLines(d) {
  const count = Math.max(d.exact.length, d.rendered.length);
  const name = (i) => (count < 2 ? "" : count === 4 ? CHANNELS[i] + ": " : i + ": ");
  const told = new Set();
  return Array.from({length: count}, (_, i) => i).filter((i) => {
    const [exact, rendered] = [d.exact[i], d.rendered[i]];
    const key = exact + " " + rendered;
    if (exact === undefined || rendered === undefined || told.has(key)) return false;
    told.add(key);
    return !Object.is(Number(exact), Number(rendered));
  }).map((i) => numberLine(name(i), d.exact[i], d.rendered[i], d.permitted?.[i]));
}
