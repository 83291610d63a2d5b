// SPDX-License-Identifier: MIT The samples of multisampled images, unpacked
// (reports/sample_data.h), and their values.

// Sample positions within a pixel as [[x, y], ...], y up; null if unreported.
function positionsOf(numbers) {
  if (!numbers) return null;
  return Array.from({length: numbers.length / 2}, (_, i) => [numbers[2 * i], numbers[2 * i + 1]]);
}

function wholeNumbers(bytes) {
  const view = new DataView(bytes.buffer);
  return Array.from({length: bytes.length / 4}, (_, i) => view.getUint32(4 * i, true));
}

// `from`: for a difference, the bytes that it is relative to.
function unpackSamples(data, one, from) {
  const image = {count: data.count, width: one.width, positions: positionsOf(data.positions)};
  image.bytes = {};
  for (const part of ["pixels", "hits", "coverage"]) {
    if (!data[part]) continue;
    const items = one.width * one.height * (part === "coverage" ? 1 : data.count);
    const bytes = unpackPixels(data[part], 4 * items);
    if (from) bytes.forEach((_, i) => { bytes[i] ^= from.bytes[part][i]; });
    image.bytes[part] = bytes;
    image[part] = part === "pixels" ? bytes : wholeNumbers(bytes);
  }
  return image;
}

// The samples of exact, as compared with an answer, and of the answer; null if there are none.
function exactSamples(one, answer) {
  if (!one.samples) return null;
  const usual = unpackSamples(one.samples, one, null);
  return answer.exact ? unpackSamples(answer.exact.samples, one, usual) : usual;
}

function renderedSamples(one, answer, exact) {
  return exact && answer.samples ? unpackSamples(answer.samples, one, exact) : null;
}

// One sample: its colour, whether a fragment covers it, and the number of writes; unreported values
// are null. `filled`: written or, if unreported, covered.
function sampleAt(image, x, y, s) {
  const pixel = y * image.width + x;
  const item = pixel * image.count + s;
  const color = image.pixels ? Array.from(image.pixels.subarray(4 * item, 4 * item + 4)) : null;
  const covered = image.coverage ? (image.coverage[pixel] >>> s & 1) === 1 : null;
  const hits = image.hits ? image.hits[item] : null;
  return {color, covered, hits, filled: hits === null ? covered === true : hits > 0};
}

// The kind of disagreement between two samples; "" if they agree.
function kindBetween(exact, rendered) {
  const told = exact.hits !== null && rendered.hits !== null;
  const before = told ? exact.hits : Number(exact.covered);
  const after = told ? rendered.hits : Number(rendered.covered);
  if (after < before) return "missing";
  if (after > before) return before ? "duplicate" : "extra";
  const colors = exact.color && rendered.color;
  return colors && exact.color.some((c, i) => c !== rendered.color[i]) ? "value" : "";
}

// The sample indices of a mask, "0 2"; and its bits, that of sample 0 last.
function maskText(mask, count) {
  const set = Array.from({length: count}, (_, s) => s).filter((s) => mask >>> s & 1);
  const bits = "0b" + (mask >>> 0).toString(2).padStart(count, "0");
  return bits + (set.length ? " {" + set.join(", ") + "}" : " none");
}

// A place in a pixel, in sixteenths if it is a multiple, as drivers report it.
function withinText([x, y]) {
  const part = (v) => (Number.isInteger(16 * v) ? 16 * v + "/16" : String(v));
  return part(x) + ", " + part(y);
}

function samePositions(a, b) {
  return a.length === b.length && a.every(([x, y], s) => x === b[s][0] && y === b[s][1]);
}
