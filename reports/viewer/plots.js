// SPDX-License-Identifier: MIT Plots: verdicts by family of cases, errors of values, and levels of
// detail along rows of pixels.

const familyOf = (one) => one.id.split(/[\/:]/)[0];
const RAMPS_SHOWN = 12;

// A bar of verdicts, worst first; the text beside it says the same.
function verdictBar(counts) {
  const bar = h("div.proportions", {"aria-hidden": "true"});
  for (const verdict of WORST_FIRST) {
    if (!counts[verdict]) continue;
    const part = h("i", {class: "f-" + verdict});
    part.style.flexGrow = counts[verdict];
    bar.append(part);
  }
  return bar;
}

function familyTable() {
  const families = new Map();
  for (const one of Cases) {
    const family = familyOf(one);
    if (!families.has(family)) families.set(family, Data.renderers.map(() => ({all: 0})));
    one.results.forEach((result, r) => {
      const counts = families.get(family)[r];
      ++counts.all;
      counts[result.verdict] = (counts[result.verdict] || 0) + 1;
    });
  }
  const cell = (counts) => h("td", {title: WORST_FIRST.filter((v) => counts[v])
    .map((v) => v + " " + counts[v]).join(", ")}, verdictBar(counts),
  shareText(counts.agree || 0, counts.all) + " agree",
  counts.violation && h("span.v-violation", {}, ", ", verdictIcon("violation"),
    " " + counts.violation.toLocaleString("en")));
  return scrolled("Families", h("table.matrix.families", {},
    h("thead", {}, h("tr", {}, ["family", "cases"].map((text) => h("th", {scope: "col"}, text)),
      Data.renderers.map((info) => h("th", {scope: "col"}, info.name)))),
    h("tbody", {}, [...families].map(([family, cells]) => h("tr", {},
      h("th", {scope: "row"}, h("a", {href: Route.href({...NOWHERE, q: family + "/"})}, family)),
      h("td.count", {}, cells[0].all.toLocaleString("en")), cells.map(cell))))));
}

// Per attribute with errors, a histogram of each renderer.
function errorPlots() {
  const names = [...new Set(Data.renderers.flatMap((info) => info.values
    .filter((v) => v.histogram.length).map((v) => v.attribute)))];
  return h("div.columns", {}, names.map((name) => h("div.errors", {}, h("h4", {}, name),
    Data.renderers.map((info) => {
      const values = info.values.find((v) => v.attribute === name);
      if (!values?.histogram.length) return null;
      return h("div", {}, h("small", {}, info.name + ": " +
        values.differing.toLocaleString("en") + " of " + values.compared.toLocaleString("en") +
        " differ"), histogramOf(values.histogram));
    }))));
}

// A small plot of an answer's levels of detail relative to exact's.
function rampSketch(one, answer) {
  const ramp = rampOf(answer);
  const points = ramp.points.map(lessExact);
  const panel = {left: 2, width: 216, columns: one.width, top: 2, height: 56,
    ...rangeOf(points, 0.02, 2)};
  const scale = panelScale(panel);
  const told = points.filter((p) => Number.isFinite(p.rendered));
  const outside = points.filter((p, i) => ramp.outside.has(ramp.points[i]));
  return svgNode("svg", {width: 220, height: 60, "aria-hidden": "true"},
    svgNode("rect", {class: "ground", x: 2, y: 2, width: 216, height: 56}),
    svgNode("path", {class: "exact", d: "M2 " + scale.y(0) + "H218"}),
    svgNode("path", {class: "dots", d: dotsPath(told, scale, 1.2)}),
    svgNode("path", {class: "outside", d: dotsPath(outside, scale, 2.5)}));
}

// A case with its renderers' levels, described as on its page.
function rampCard(one) {
  const place = h("span", {}, "\u2026");
  const sketch = (answer) => {
    const renderers = one.results.filter((r) => r.answer === answer).map((r) => r.renderer);
    const first = Data.renderers.findIndex((info) => info.name === renderers[0]);
    return h("span", {class: "r-" + first % 8}, rampSketch(one, answer),
      h("small.faint", {}, renderers.join(", ") + ": " + answer.ramp.words));
  };
  loadDetails(one).then(() => replace(place,
    [...new Set(one.results.map((r) => r.answer))].filter((a) => a.ramp).map(sketch)),
  () => replace(place, "no details"));
  return h("a.ramp-card", {href: Route.href({case: one.id})}, h("small", {}, one.id), place);
}

function rampCards() {
  const cases = Cases.filter((one) => one.hasRamp);
  if (!cases.length) return null;
  return [h("h3", {}, "Levels of detail less exact ", h("span.faint", {},
    plural(cases.length, "case", "cases") + ", the worst first")),
  h("div.ramps.ramp-cards", {}, [...cases].sort((a, b) => b.worst - a.worst || a.index - b.index)
    .slice(0, RAMPS_SHOWN).map(rampCard))];
}

function plots() {
  const errors = Data.renderers.some((info) => info.values.some((v) => v.histogram.length));
  return [h("h3", {}, "Agreement by family"), familyTable(),
    errors && [h("h3", {}, "Errors of values ", h("span.faint", {}, "components by error, ULP")),
      errorPlots()], rampCards()];
}
