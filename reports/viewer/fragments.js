// SPDX-License-Identifier: MIT
// The fragments that both sides make at one pixel, in numbers.

const CHANNELS = ["red", "green", "blue", "alpha"];
const MOST_PAIRS = 8;  // shown until the user asks for all

// One side's fragments at a pixel; unreported depths and colours are null.
function fragmentsAt(list, {x, y}) {
  return list.filter((f) => f[0] === x && f[1] === y)
    .map(([, , primitive, coverage, depth, color, pass]) =>
      ({primitive, coverage, depth, color, pass}));
}

// Pairs of fragments with equal primitive, pass and sample; either side may be null.
function pairsOf(exact, rendered) {
  const rest = [...rendered];
  const match = (one) => (other) => one.primitive === other.primitive && one.pass === other.pass &&
    (one.coverage === other.coverage || (one.coverage & other.coverage) !== 0);
  const pairs = exact.map((one) => {
    const at = rest.findIndex(match(one));
    return {exact: one, rendered: at < 0 ? null : rest.splice(at, 1)[0], kind: ""};
  });
  for (const pair of pairs) pair.kind = pair.rendered ? "" : "missing";
  for (const other of rest)
    pairs.push({exact: null, rendered: other, kind: exact.some((one) => match(one)(other)) ?
      "duplicate" : "extra"});
  const order = ({exact: a, rendered: b}) => [(a || b).pass ?? 0, (a || b).primitive];
  return pairs.sort((a, b) => order(a)[0] - order(b)[0] || order(a)[1] - order(b)[1]);
}

// True if the answer holds the fragments of a pixel. For large cases it holds those of disputed
// pixels.
function tellsFragments(one, answer, {x, y}) {
  if (!answer.fragments) return false;
  const is = (place) => place.x === x && place.y === y;
  return answer.fragments.exact.length === one.fragments || answer.disagreements.some(is) ||
    answer.values.some((v) => v.differing && is(v.worst));
}

const sideCells = (value, what) =>
  (value === undefined || value === null ? h("td.faint", {colspan: 3}, what) : numberCells(value));

// One number of both sides; the rendered one is omitted if it is equal.
function numberRow(name, exact, rendered, pair) {
  const both = pair.exact && pair.rendered && exact !== null && rendered !== null;
  const told = (side) => (side ? "not told" : name === "depth" ? "no fragment" : "");
  const alike = both && Object.is(Number(exact), Number(rendered));
  const steps = both ? floatSteps(exact, rendered) : null;
  return h("tr", {class: both && !alike ? "differs" : ""}, h("th", {scope: "row"}, name),
    sideCells(exact, told(pair.exact)),
    alike ? h("td.faint", {colspan: 4}, "the same") : [sideCells(rendered, told(pair.rendered)),
      h("td", {}, steps === null ? "" : (steps > 0 ? "+" : "") + steps.toLocaleString("en") + " ULP")]);
}

function coverageRow(pair, count) {
  const text = (side) => (side ? maskText(side.coverage, count) : "no fragment");
  const alike = text(pair.exact) === text(pair.rendered);
  return h("tr", {class: alike ? "" : "differs"}, h("th", {scope: "row"}, "coverage"),
    h("td", {colspan: 3}, text(pair.exact)),
    h("td", {colspan: 4, class: alike ? "faint" : ""}, alike ? "the same" : text(pair.rendered)));
}

function pairBody(pair, samples) {
  const {exact, rendered, kind} = pair;
  const {primitive, pass} = exact || rendered;
  const of = (side, channel) => (side?.color ? side.color[channel] : null);
  return h("tbody", {}, h("tr", {}, h("th.of-pair", {colspan: 8, scope: "rowgroup"},
    "primitive " + primitive + (pass === undefined ? "" : ", pass " + (pass + 1)), " ",
    kind && kindLabel(kind))),
  samples && coverageRow(pair, samples.count),
  numberRow("depth", exact?.depth ?? null, rendered?.depth ?? null, pair),
  CHANNELS.map((name, i) => numberRow(name, of(exact, i), of(rendered, i), pair)));
}

// The text instead of an empty table.
function noFragments(one, answer, pixel) {
  return h("p.faint", {}, tellsFragments(one, answer, pixel) ? "Neither side makes one here." :
    "The results hold the fragments of disputed pixels; nothing is disputed here.");
}

function fragmentsTable(one, pairs, most, showAll) {
  const heads = ["decimal", "hex", "float bits"].map((text) => h("th", {scope: "col"}, text));
  return [scrolled("Fragments in numbers", h("table.numbers.mono", {},
    h("thead", {}, h("tr", {}, h("td", {}), h("th", {colspan: 3, scope: "colgroup"}, "exact"),
      h("th", {colspan: 3, scope: "colgroup"}, "rendered"), h("td", {})),
    h("tr", {}, h("td", {}), heads, heads.map((head) => head.cloneNode(true)),
      h("th", {scope: "col"}, "apart"))),
    pairs.slice(0, most).map((pair) => pairBody(pair, one.samples)))),
  pairs.length > most && h("button", {onclick: showAll}, "All " + pairs.length)];
}

// The section of a chosen pixel; nothing for answers that differ nowhere.
function fragmentsSection(one, answer, pixel) {
  if (!answer.fragments || !pixel) return null;
  const {exact, rendered} = answer.fragments;
  const pairs = pairsOf(fragmentsAt(exact, pixel), fragmentsAt(rendered, pixel));
  const body = h("div", {});
  const show = (most) => replace(body, pairs.length
    ? fragmentsTable(one, pairs, most, () => show(pairs.length)) : noFragments(one, answer, pixel));
  show(MOST_PAIRS);
  return h("section.card", {}, h("h2", {}, "Fragments at pixel (" + pixel.x + ", " + pixel.y + ")"),
    body);
}
