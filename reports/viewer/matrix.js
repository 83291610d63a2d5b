// SPDX-License-Identifier: MIT Rule by renderer: the cases that are about a rule, or in which
// something was found by it, counted by their verdict under it.

const MATRIX_SHOWN = 10;

// rule -> by renderer {verdict: number of cases}.
function countByRule() {
  const counts = new Map();
  const of = (rule) => {
    if (!counts.has(rule)) counts.set(rule, Data.renderers.map(() => ({})));
    return counts.get(rule);
  };
  for (const one of Cases) {
    const rules = new Set(one.rules);
    for (const result of one.results) for (const rule of result.found.keys()) rules.add(rule);
    for (const rule of rules) {
      const row = of(rule);
      one.results.forEach((result, r) => {
        const verdict = verdictBy(one, result, rule);
        row[r][verdict] = (row[r][verdict] || 0) + 1;
      });
    }
  }
  return counts;
}

// Rules with the most violations first, then the most of what is permitted, and so on.
function byWeight([, a], [, b]) {
  for (const verdict of WORST_FIRST) {
    const sum = (row) => row.reduce((all, cell) => all + (cell[verdict] || 0), 0);
    if (sum(a) !== sum(b)) return sum(b) - sum(a);
  }
  return 0;
}

function matrixCell(rule, renderer, cell) {
  return h("td", {}, WORST_FIRST.filter((verdict) => cell[verdict]).map((verdict) =>
    h("a.count-of", {
      class: "v-" + verdict, href: Route.href({...NOWHERE, rule, renderer, verdict}),
      title: verdict,
    }, icon(VERDICTS[verdict].path), h("span.unseen", {}, verdict + " "),
    cell[verdict].toLocaleString("en"))));
}

function matrixTable() {
  const rows = [...countByRule()].sort(byWeight);
  const body = h("tbody", {});
  const more = h("p.more", {});
  const paint = (all) => {
    replace(body, (all ? rows : rows.slice(0, MATRIX_SHOWN)).map(([rule, cells]) => h("tr", {},
      h("th", {scope: "row"}, ruleChip(rule)),
      cells.map((cell, r) => matrixCell(rule, Data.renderers[r].name, cell)))));
    replace(more, rows.length > MATRIX_SHOWN && h("button.link", {onclick: () => paint(!all)},
      all ? "Show the first " + MATRIX_SHOWN : "Show all " + rows.length + " rules"));
  };
  paint(false);
  return [h("p.legend-line.faint", {}, WORST_FIRST.map((verdict) =>
    h("span.verdict", {}, verdictIcon(verdict), verdict))),
  scrolled("Rules by renderer", h("table.matrix", {},
    h("thead", {}, h("tr", {}, h("th", {scope: "col"}, "rule"),
      Data.renderers.map((info) => h("th", {scope: "col"}, info.name)))), body)), more];
}
