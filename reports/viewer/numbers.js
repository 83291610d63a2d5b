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

// Values of a disagreement, number by number, on both sides.
function numbersOf(d) {
  const count = Math.max(d.exact.length, d.rendered.length);
  const rows = Array.from({length: count}, (_, i) => {
    const exact = d.exact[i];
    const rendered = d.rendered[i];
    const both = exact !== undefined && rendered !== undefined;
    const steps = both ? floatSteps(exact, rendered) : null;
    const row = (name, value, last) => value !== undefined && h("tr", {},
      h("th", {scope: "row"}, count > 1 ? name + " " + i : name), numberCells(value),
      h("td", {}, last));
    return [row("exact", exact, ""), row("rendered", rendered, steps === null ? "" :
      (steps > 0 ? "+" : "") + steps.toLocaleString("en") + " ULP")];
  });
  return h("section.card", {}, h("h2", {}, "Values in dispute at " + pixelText(d)),
    scrolled("Values in numbers", h("table.numbers.mono", {},
    h("thead", {}, h("tr", {}, ["", "decimal", "hex", "float bits", "apart"].map((text) =>
      (text ? h("th", {scope: "col"}, text) : h("td", {}))))), h("tbody", {}, rows))));
}
