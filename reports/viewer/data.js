// SPDX-License-Identifier: MIT
// The report's data, read once and indexed; images are unpacked when a case is shown.

const Report = JSON.parse(byId("data").textContent);
const Rules = new Map(Report.rules.map((rule) => [rule.id, rule]));
const Rulings = new Map(Report.rulings.map((ruling) => [ruling.number, ruling]));
const CasesById = new Map();
const isSurprise = (result) => result.standing !== "expected";

function worstOf(results) {
  const ranks = results.map((r) => VERDICTS[r.verdict].rank);
  return ranks.length ? Math.max(...ranks) : 0;
}

function indexCase(one, index) {
  one.index = index;
  one.results.forEach((result, r) => {
    result.answer = one.answers[result.answer];
    result.renderer = Report.renderers[r] ? Report.renderers[r].name : "?";
  });
  const found = one.answers.flatMap((answer) =>
    [...answer.disagreements, ...answer.values.filter((v) => v.differing)].map((d) => d.rule));
  one.allRules = new Set(one.rules.concat(found));
  one.surprises = one.results.filter(isSurprise).length;
  one.worst = worstOf(one.results);
  one.search = [one.id, one.title, one.why, one.spec, one.file, ...one.tags, ...one.allRules]
    .join("\n").toLowerCase();
  CasesById.set(one.id, one);
}
Report.cases.forEach(indexCase);

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

// The inverse of pack_pixels in reports/pixels.cpp: `size` bytes of RGBA8, bottom row first.
function unpackPixels(base64, size) {
  const packed = bytesOf(base64);
  const out = new Uint8ClampedArray(size);
  let at = 0;
  let to = 0;
  const number = () => {
    let value = 0;
    for (let factor = 1; at < packed.length; factor *= 128) {
      const byte = packed[at++];
      value += (byte & 127) * factor;
      if (byte < 128) break;
    }
    return value;
  };
  while (at < packed.length && to < size) {
    const packet = number();
    const count = Math.floor(packet / 2);
    const stored = packet % 2 ? 4 : 4 * count;
    const pixels = packed.subarray(at, at + stored);
    for (let i = 0; i < (packet % 2 ? count : 1) && to < size; ++i, to += stored)
      out.set(pixels.subarray(0, size - to), to);
    at += stored;
  }
  return out;
}

function applyDifference(pixels, packed) {
  const difference = unpackPixels(packed, pixels.length);
  for (let i = 0; i < pixels.length; ++i) pixels[i] ^= difference[i];
  return pixels;
}

// The exact image that an answer was held against and, of the answer, the rendered one; null where
// there is none.
function exactPixels(one, answer) {
  if (!one.pixels) return null;
  const pixels = unpackPixels(one.pixels, 4 * one.width * one.height);
  return answer.exact ? applyDifference(pixels, answer.exact.difference) : pixels;
}

function renderedPixels(one, answer, exact) {
  if (answer.blank || !exact) return null;
  const pixels = exact.slice();
  return answer.difference ? applyDifference(pixels, answer.difference) : pixels;
}
