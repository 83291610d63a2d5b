// SPDX-License-Identifier: MIT The report's index (reports/report_index.h), read once, and images,
// unpacked when a case is shown.

const Data = JSON.parse(byId("data").textContent);
const VERDICTS = Data.verdicts;
const WORST_FIRST = Object.keys(VERDICTS);
const PIXEL_VERDICTS = WORST_FIRST.filter((verdict) => verdict !== "not-run").reverse();
const Rules = new Map(Data.rules.map((rule) => [rule.id, rule]));
const Rulings = new Map(Data.rulings.map((ruling) => [ruling.number, ruling]));
const CasesById = new Map();
const isSurprise = (result) => isRed(result.standing);

// Rule -> the worst verdict under it.
function findingsOf(numbers) {
  const found = new Map();
  for (let i = 0; i < numbers.length; i += 2) found.set(Data.names[numbers[i]], numbers[i + 1]);
  return found;
}

const Heads = Data.heads.map((head) => ({
  ...head, rules: head.rules.map((number) => Data.names[number]),
}));
const Outcomes = Data.outcomes.map(([verdict, standing, found]) =>
  ({verdict, standing, found: findingsOf(found)}));

// The positions of cases in which something differs, the worst first.
const Order = [];
Data.order.forEach((index, place) => { Order[index] = place; });

// One line of the list; everything else about a case is loaded with its details (details.js).
class Case {
  constructor([head, rest, fragments, outcomes, line, hasRamp], index) {
    const {stem, source, ...words} = Heads[head];
    this.id = stem + rest;
    this.head = head;
    this.title = words.title;
    this.why = words.why;
    this.rules = words.rules;
    this.spec = words.spec;
    this.origin = words.origin;
    this.tags = words.tags;
    this.file = words.file;
    this.surface = words.surface;
    this.width = words.width;
    this.height = words.height;
    this.index = index;
    this.fragments = fragments;
    this.line = line;            // of its details, or undefined
    this.sourceLine = source;    // of its file's text, or undefined
    this.hasRamp = hasRamp === 1;
    this.results = outcomes.map((number, r) =>
      ({...Outcomes[number], renderer: Data.renderers[r].name}));
    this.surprises = this.results.filter(isSurprise).length;
    this.worst = this.results.reduce((worst, r) => Math.max(worst, VERDICTS[r.verdict].rank), 0);
    this.order = Order[index] ?? Data.cases.length;  // among those of one verdict
    this.words = null;
  }

  // True for the rules that the case is about, and those by which something was found.
  hasRule(id) {
    return this.rules.includes(id) || this.results.some((result) => result.found.has(id));
  }

  // The text that is searched.
  get search() {
    this.words ??= [this.id, this.title, this.why, this.spec, this.file, ...this.tags,
      ...this.rules, ...this.results.flatMap((result) => [...result.found.keys()])]
      .join("\n").toLowerCase();
    return this.words;
  }
}

const Cases = Data.cases.map((row, index) => new Case(row, index));
for (const one of Cases) CasesById.set(one.id, one);

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

// The exact image that an answer was compared with, and the answer's own; null if there is none.
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
